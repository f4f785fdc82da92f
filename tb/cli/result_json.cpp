#include "tb/cli/result_json.h"

#include <string>

#include "model/core/input_error.h"
#include "tb/support/json.h"

namespace cosim::cli {
namespace {

constexpr const char* total = "total";
constexpr const char* largest = "largest";

// In full: a finished sweep is not run again to learn what it measures.
Json to_json(const Measure& m) {
  Json j{{"name", m.name},
         {"sum", m.sum == Measure::Sum::total ? total : largest},
         {"title", m.title},
         {"unit", m.unit}};
  std::visit([&](auto value) { j["value"] = value; }, m.value);
  return j;
}

void get_count(const Json& j, const char* name, std::uint64_t& count) {
  if (!j.at(name).is_number_unsigned()) throw InputError(std::string(name) + ": no count");
  j.at(name).get_to(count);
}

Measure measure_from_json(const Json& j) {
  Measure m;
  j.at("name").get_to(m.name);
  if (j.at("sum") != total && j.at("sum") != largest) throw InputError("sum: no rule");
  m.sum = j.at("sum") == total ? Measure::Sum::total : Measure::Sum::largest;
  j.at("title").get_to(m.title);
  j.at("unit").get_to(m.unit);
  if (const Json& value = j.at("value"); value.is_number_float()) {
    m.value = value.get<double>();
  } else {
    get_count(j, "value", m.value.emplace<std::uint64_t>());
  }
  return m;
}

}  // namespace

Json to_json(const Result& r) {
  Json measures = Json::array();
  for (const Measure& m : r.checked.measures) measures.push_back(to_json(m));
  return {{"cases", r.cases},
          {"clocks", r.clocks},
          {"jobs", r.checked.jobs},
          {"measures", measures},
          {"left_out", r.left_out}};
}

Result result_from(const Json& j) {
  Result r;
  get_count(j, "cases", r.cases);
  get_count(j, "clocks", r.clocks);
  get_count(j, "jobs", r.checked.jobs);
  for (const Json& one : j.at("left_out")) {
    if (!one.is_number_unsigned()) throw InputError("left_out: no count");
    r.left_out.push_back(one.get<std::uint64_t>());
  }
  for (const Json& one : j.at("measures")) r.checked.measures.push_back(measure_from_json(one));
  return r;
}

}  // namespace cosim::cli
