#include "tb/cli/result_json.h"

#include "tb/util/json.h"

namespace cosim::cli {
namespace {

constexpr const char* total = "total";
constexpr const char* largest = "largest";

// In full: a finished sweep is not run again to learn what it measures.
Json measure_json(const Measure& m) {
  Json j{{"name", m.name},
         {"sum", m.sum == Measure::Sum::total ? total : largest},
         {"title", m.title},
         {"unit", m.unit}};
  std::visit([&](auto value) { j["value"] = value; }, m.value);
  return j;
}

Measure measure_from(const JsonAt& j) {
  // Many of them can be added up.
  constexpr double most = 1e300;
  Measure m;
  m.name = j.at("name").text();
  const JsonAt sum = j.at("sum");
  if (sum.text() != total && sum.text() != largest) sum.fail("names no sum");
  m.sum = sum.text() == total ? Measure::Sum::total : Measure::Sum::largest;
  m.title = j.at("title").text();
  m.unit = j.at("unit").text();
  if (const JsonAt value = j.at("value"); value.json().is_number_float()) {
    m.value = value.number(-most, most);
  } else {
    m.value = value.whole();
  }
  return m;
}

}  // namespace

Json to_json(const Result& r) {
  Json measures = Json::array();
  for (const Measure& m : r.checked.measures) measures.push_back(measure_json(m));
  Json json{{"cases", r.cases},
            {"clocks", r.clocks},
            {"jobs", r.checked.jobs},
            {"measures", measures},
            {"left_out", r.left_out}};
  for (const Transactions& one : r.streams) json["streams"].push_back({one.moved, one.compared});
  if (!r.happened.empty()) json["happened"] = r.happened;
  return json;
}

Result result_from(const JsonAt& j, const AnyBench& bench) {
  Result r;
  r.cases = j.at("cases").whole();
  r.clocks = j.at("clocks").whole();
  r.checked.jobs = j.at("jobs").whole();
  const JsonAt left_out = j.at("left_out");
  if (!left_out.list().empty()) {
    const std::size_t signals = bench.compared().size();
    for (const JsonAt& one : left_out.list(signals, signals)) r.left_out.push_back(one.whole());
  }
  if (const auto streams = j.find("streams")) {
    const std::size_t all = bench.streams().size();
    for (const JsonAt& one : streams->list(all, all)) {
      const auto figures = one.list(2, 2);
      r.streams.push_back({figures[0].whole(), figures[1].whole()});
    }
  }
  if (const auto happened = j.find("happened")) {
    const std::size_t all = bench.cases().size();
    for (const JsonAt& one : happened->list(all, all)) r.happened.push_back(one.whole());
  }
  for (const JsonAt& one : j.at("measures").list()) {
    Checked with;
    with.measures.push_back(measure_from(one));
    add(r.checked, with);
  }
  return r;
}

}  // namespace cosim::cli
