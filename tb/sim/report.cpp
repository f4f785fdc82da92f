#include "tb/sim/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "tb/util/finite.h"
#include "tb/util/json.h"
#include "tb/util/output_file.h"
#include "tb/util/show.h"
#include "tb/util/words.h"

namespace cosim {

constexpr const char* nothing = "nothing compared";

Json parameters(const AnyBench& bench) {
  Json object = Json::object();
  for (const Parameter& p : bench.parameters()) {
    object[p.name] = p.text != nullptr ? Json(p.text) : Json(p.value);
  }
  return object;
}

namespace {

Json signal_names(const AnyBench& bench) {
  Json names = Json::array();
  for (const Field& f : bench.compared()) names.push_back(label_of(f));
  return names;
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
  object["kind"] = m.finding.empty() ? "lockstep" : "finding";
  if (!m.finding.empty()) object["finding"] = m.finding;
  if (!m.told.empty()) object["told"] = m.told;
  object["clock"] = m.clock;
  object["signal"] = m.signal;
  if (m.field.width != 0) {
    object["expected"] = show(m.field, m.expected);
    object["actual"] = show(m.field, m.actual);
  }
  Json traces = Json::array();
  for (const Trace& t : m.traces) {
    Json trace;
    trace["signal"] = label_of(t.field);
    trace["first_clock"] = m.first;
    for (std::size_t c = 0; c < t.expected.size(); ++c) {
      trace["expected"].push_back(t.compared(c) ? show_short(t.field, t.expected[c]) : "-");
    }
    for (const Word w : t.actual) trace["actual"].push_back(show_short(t.field, w));
    traces.push_back(trace);
  }
  object["traces"] = traces;
  return object;
}

void put_measures(Json& object, const Checked& checked) {
  for (const Measure& m : checked.measures) {
    std::visit([&](auto value) { object[m.name] = value; }, m.value);
  }
}

Json assumed(const AnyBench& bench) {
  Json all = Json::array();
  for (const std::string& rule : bench.assumed()) all.push_back(rule);
  return all;
}

void put_left_out(Json& object, const AnyBench& bench, const Result& r) {
  const std::vector<Field> fields = bench.compared();
  for (std::size_t i = 0; i < r.left_out.size(); ++i) {
    if (r.left_out[i] == 0 || fields[i].index > 0) continue;  // an array once
    object["left_out"][fields[i].name] = r.left_out[i];
    if (r.left_out[i] == r.clocks) object["never_compared"].push_back(fields[i].name);
  }
}

void put_cases(Json& object, const AnyBench& bench, const Result& r) {
  for (std::size_t i = 0; i < r.happened.size(); ++i) {
    object["cases"][bench.cases()[i]] = r.happened[i];
  }
}

// Of a failure that was shrunk there are no figures.
void put_streams(Json& object, const AnyBench& bench, const Result& r) {
  for (std::size_t s = 0; s < r.streams.size(); ++s) {
    const auto& [name, goes_in] = bench.streams()[s];
    object["streams"][name][goes_in ? "in" : "out"] = r.streams[s].moved;
    if (!goes_in) object["streams"][name]["compared"] = r.streams[s].compared;
  }
}

const char* json_verdict(const std::vector<Outcome>& outcomes) {
  return !all_match(outcomes) ? "mismatch" : verdict_of(outcomes) == "match" ? "match" : nothing;
}

Json run_object(const Outcome& o) {
  Json object;
  object["verdict"] = json_verdict({o});
  object["design"] = o.bench->design();
  object["parameters"] = parameters(*o.bench);
  object["work"] = o.work;
  if (!o.bench->unobserved().empty()) object["unobserved"] = o.bench->unobserved();
  if (Json rules = assumed(*o.bench); !rules.empty()) object["assumed"] = std::move(rules);
  object["clocks"] = o.result.clocks;
  put_streams(object, *o.bench, o.result);
  put_cases(object, *o.bench, o.result);
  put_left_out(object, *o.bench, o.result);
  put_measures(object, o.result.checked);
  if (!o.result.match()) object["mismatch"] = mismatch(o.result);
  return object;
}

// A design, or the part of it that a bench looks at.
std::string looked_at(const AnyBench& bench) {
  return bench.view().empty() ? bench.design() : bench.design() + ' ' + bench.view();
}

// All that is looked at, each by its first bench, in order of appearance.
std::vector<const AnyBench*> designs(const std::vector<Outcome>& outcomes) {
  std::vector<const AnyBench*> found;
  for (const Outcome& o : outcomes) {
    const auto same = [&](const AnyBench* bench) {
      return looked_at(*bench) == looked_at(*o.bench);
    };
    if (std::ranges::none_of(found, same)) found.push_back(o.bench);
  }
  return found;
}

// All runs of that: their clocks and transactions, and on how many clocks each signal was left out,
// an array once.
struct Sum {
  std::uint64_t clocks = 0;
  std::map<std::string, std::uint64_t> left_out;
  std::vector<Transactions> streams;
  std::vector<std::uint64_t> happened;
};
Sum sum_of(const std::vector<Outcome>& outcomes, const std::string& looked) {
  Sum sum;
  for (const Outcome& o : outcomes) {
    if (looked_at(*o.bench) != looked) continue;
    sum.clocks += o.result.clocks;
    add(sum.streams, o.result.streams);
    add(sum.happened, o.result.happened);
    // Shapes have arrays of other lengths.
    const std::vector<Field> fields = o.bench->compared();
    for (std::size_t i = 0; i < o.result.left_out.size(); ++i) {
      if (fields[i].index <= 0) sum.left_out[fields[i].name] += o.result.left_out[i];
    }
  }
  return sum;
}

}  // namespace

std::string verdict_of(const std::vector<Outcome>& outcomes) {
  if (!all_match(outcomes)) return "MISMATCH";
  return outcomes.empty() || std::ranges::any_of(outcomes, compared_nothing) ? nothing : "match";
}

std::string measured_text(const Result& result) {
  std::string text;
  for (const Measure& measure : result.checked.measures) {
    if (result.mismatch && measure.sum != Measure::Sum::total) continue;
    text += (text.empty() ? "" : ", ") + to_text(measure);
  }
  if (text.empty()) text = count(result.clocks, "clock");
  return text + (result.mismatch ? " before the first difference" : "");
}

// Hostile clocks are no jobs: the oracle has nothing to count.
std::string swept_text(const Result& result) {
  if (result.checked.jobs == 0) return count(result.clocks, "clock");
  return count(result.cases, "case") + ", " + measured_text(result);
}

std::string cases_text(const std::string& of, const std::vector<std::string>& cases,
                       const std::vector<std::uint64_t>& happened) {
  constexpr std::size_t most = 20;
  std::vector<std::string> never;
  for (std::size_t i = 0; i < happened.size(); ++i) {
    if (happened[i] == 0) never.push_back(cases[i]);
  }
  std::string text = fmt::format("cases{}: {} of {} happened\n", of, happened.size() - never.size(),
                                 happened.size());
  for (std::size_t i = 0; i < std::min(never.size(), most); ++i) {
    text += fmt::format("never happened{}: {}\n", of, never[i]);
  }
  if (never.size() > most) {
    text +=
        fmt::format("never happened{}: {} more, which --report names\n", of, never.size() - most);
  }
  return text;
}

bool all_match(const std::vector<Outcome>& outcomes) {
  return std::ranges::all_of(outcomes, [](const Outcome& o) { return o.result.match(); });
}

std::string compared_signals(const std::vector<const AnyBench*>& shapes) {
  std::set<std::string> texts;
  std::set<std::size_t> registers, outputs;
  for (const AnyBench* bench : shapes) {
    texts.insert(bench->compared_text());
    registers.insert(bench->registers());
    outputs.insert(bench->compared().size() - bench->registers());
  }
  if (texts.size() == 1) return *texts.begin();
  const auto between = [](const std::set<std::size_t>& of, const std::string& noun) {
    return of.size() == 1 ? count(*of.begin(), noun)
                          : fmt::format("{} to {}", *of.begin(), count(*of.rbegin(), noun));
  };
  return between(registers, "register") + " and " + between(outputs, "output");
}

std::string comparison_text(const std::vector<Outcome>& outcomes) {
  std::string text;
  const auto benches = designs(outcomes);
  for (const AnyBench* bench : benches) {
    const auto [clocks, signals, streams, happened] = sum_of(outcomes, looked_at(*bench));
    const std::string of = benches.size() > 1 ? " of " + looked_at(*bench) : "";
    std::vector<const AnyBench*> shapes;
    for (const Outcome& o : outcomes) {
      if (looked_at(*o.bench) == looked_at(*bench)) shapes.push_back(o.bench);
    }
    text += fmt::format("compared: {}{} on {} clock{}\n", compared_signals(shapes), of,
                        clocks == 1 ? "the one" : fmt::format("each of {}", clocks),
                        clocks == 1 ? "" : "s");
    if (!streams.empty()) {
      text += fmt::format("transactions{}: {}\n", of, streams_text(*bench, streams));
    }
    if (!happened.empty()) text += cases_text(of, bench->cases(), happened);
    if (const auto& left = bench->unobserved(); !left.empty()) {
      text += fmt::format("unobserved{}: {}: {}\n", of, count(left.size(), "signal"),
                          fmt::join(bench->patterns(), ", "));
    }
    for (const std::string& rule : bench->assumed()) {
      text += fmt::format("assumed of the inputs{}: {}\n", of, rule);
    }
    for (const auto& [name, left_out] : signals) {
      if (left_out == 0) continue;
      text += left_out == clocks
                  ? fmt::format("never compared{}: {}, it means nothing on any clock\n", of, name)
                  : fmt::format("left out{}: {} on {} of the clocks, where it means nothing\n", of,
                                name, left_out);
    }
    for (std::size_t s = 0; s < streams.size(); ++s) {
      const auto& [name, goes_in] = bench->streams()[s];
      if (goes_in || streams[s].compared > 0) continue;
      text +=
          fmt::format("never compared{}: {}, no transaction came that was expected\n", of, name);
    }
  }
  return text;
}

std::string verdict_text(const std::vector<Outcome>& outcomes) {
  std::string text;
  for (const Outcome& o : outcomes) {
    if (o.result.match()) continue;
    text += fmt::format("{}, {}\n", o.bench->title(), o.result.failed);
    if (o.result.mismatch) {
      text += to_text(*o.result.mismatch);
    } else {
      text +=
          fmt::format("RTL and model agree, but the checker reports: {}\n", o.result.checked.error);
    }
  }
  return text + fmt::format("verdict: {}\n", verdict_of(outcomes));
}

std::string report_json(const std::vector<Outcome>& outcomes, std::uint64_t seed,
                        const std::string& extra) {
  Json runs = Json::array();
  for (const Outcome& o : outcomes) runs.push_back(run_object(o));

  Json top;
  if (outcomes.size() == 1) {
    top = runs.front();
  } else {
    top["verdict"] = json_verdict(outcomes);
    top["design"] = Json::array();
    top["parameters"] = Json::array();
    Result sum;
    std::set<const AnyBench*> named;
    for (const Outcome& o : outcomes) {
      if (named.insert(o.bench).second) top["parameters"].push_back(parameters(*o.bench));
      add(sum, o.result);
    }
    top["clocks"] = sum.clocks;
    put_measures(top, sum.checked);
    for (const Json& run : runs) {
      if (run.contains("mismatch") && !top.contains("mismatch")) top["mismatch"] = run["mismatch"];
    }
  }

  const auto benches = designs(outcomes);
  if (benches.size() == 1) {
    top["design"] = benches.front()->design();
    top["compared_signals"] = signal_names(*benches.front());
  } else {
    top["compared_signals"] = Json::object();
    for (const AnyBench* bench : benches) {
      top["design"].push_back(looked_at(*bench));
      top["compared_signals"][looked_at(*bench)] = signal_names(*bench);
    }
  }
  top["seed"] = seed;
  top.update(json_of(extra));
  top["runs"] = std::move(runs);
  check_finite(top);
  return json_text(top, 2);
}

std::string run_json(const Outcome& outcome) {
  const Json run = run_object(outcome);
  check_finite(run);
  return json_text(run);
}

void write_report(const std::string& path, const std::string& text) {
  write_file(path, text + '\n');
}

}  // namespace cosim
