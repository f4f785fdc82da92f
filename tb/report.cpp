#include "tb/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tb/output_file.h"
#include "tb/show.h"

namespace cosim {
namespace {

using Json = nlohmann::ordered_json;

bool all_match(const std::vector<Outcome>& outcomes) {
  return std::all_of(outcomes.begin(), outcomes.end(),
                     [](const Outcome& o) { return o.result.match(); });
}

Json signal_names(const AnyBench& bench) {
  Json names = Json::array();
  for (const Field& f : bench.compared()) names.push_back(f.name);
  return names;
}

Json parameters(const AnyBench& bench) {
  Json object = Json::object();
  for (const Parameter& p : bench.parameters()) object[p.name] = p.value;
  return object;
}

Json mismatch(const Result& r) {
  Json object;
  object["case"] = r.failed;
  if (!r.mismatch) {
    object["kind"] = "oracle";
    object["what"] = r.checked.error;
    return object;
  }
  const Mismatch& m = *r.mismatch;
  object["kind"] = "lockstep";
  object["clock"] = m.clock;
  object["signal"] = m.signal;
  object["expected"] = show(m.field, m.expected);
  object["actual"] = show(m.field, m.actual);
  Json traces = Json::array();
  for (const Trace& t : m.traces) {
    Json trace;
    trace["signal"] = t.field.name;
    trace["first_clock"] = m.first;
    for (const Word w : t.expected) trace["expected"].push_back(show_short(t.field, w));
    for (const Word w : t.actual) trace["actual"].push_back(show_short(t.field, w));
    traces.push_back(trace);
  }
  object["traces"] = traces;
  return object;
}

Json outcome_json(const Outcome& o) {
  Json object;
  object["verdict"] = o.result.match() ? "match" : "mismatch";
  object["design"] = o.bench->design();
  object["parameters"] = parameters(*o.bench);
  object["work"] = o.work;
  object["clocks"] = o.result.clocks;
  object["steps"] = o.result.checked.steps;
  object["compared_signals"] = signal_names(*o.bench);
  object["max_deviation"] = o.result.checked.max_deviation;
  if (!o.result.match()) object["mismatch"] = mismatch(o.result);
  return object;
}

}  // namespace

std::string compared_signals(const AnyBench& bench) {
  const std::size_t registers = bench.registers();
  return fmt::format("{} registers and {} outputs", registers, bench.compared().size() - registers);
}

std::string verdict_text(const std::vector<Outcome>& outcomes) {
  std::string text;
  for (const Outcome& o : outcomes) {
    if (o.result.match()) continue;
    text += fmt::format("{}, {}\n", o.bench->title(), o.result.failed);
    if (o.result.mismatch) {
      text += to_text(*o.result.mismatch);
    } else {
      text += fmt::format("RTL and model agree, and both are wrong: {}\n", o.result.checked.error);
    }
  }
  return text + fmt::format("verdict: {}\n", all_match(outcomes) ? "match" : "MISMATCH");
}

std::string report_json(const std::vector<Outcome>& outcomes, std::uint64_t seed,
                        const std::string& extra) {
  Json top;
  if (outcomes.size() == 1) {
    top = outcome_json(outcomes.front());
  } else {
    top["verdict"] = all_match(outcomes) ? "match" : "mismatch";
    top["design"] = Json::array();
    top["parameters"] = Json::array();
    top["clocks"] = std::uint64_t{0};
    top["steps"] = std::uint64_t{0};
    top["compared_signals"] = Json::object();
    top["max_deviation"] = 0.0;
    top["runs"] = Json::array();
    for (const Outcome& o : outcomes) {
      const Json run = outcome_json(o);
      const std::string design = o.bench->design();
      if (std::find(top["design"].begin(), top["design"].end(), design) == top["design"].end()) {
        top["design"].push_back(design);
      }
      top["parameters"].push_back(run["parameters"]);
      top["clocks"] = top["clocks"].get<std::uint64_t>() + o.result.clocks;
      top["steps"] = top["steps"].get<std::uint64_t>() + o.result.checked.steps;
      top["compared_signals"][design] = run["compared_signals"];
      top["max_deviation"] =
          std::max(top["max_deviation"].get<double>(), o.result.checked.max_deviation);
      if (run.contains("mismatch") && !top.contains("mismatch")) top["mismatch"] = run["mismatch"];
      top["runs"].push_back(run);
    }
  }
  top["seed"] = seed;
  top.update(Json::parse(extra));
  return top.dump(2);
}

void write_report(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.line("{}", text);
  file.close();
}

}  // namespace cosim
