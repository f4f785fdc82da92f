#include "tb/regress/report.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/util/json.h"
#include "tb/util/json_at.h"
#include "tb/util/output_file.h"
#include "tb/util/words.h"

namespace cosim::regress {
namespace {

// What a part says of a failure.
Json failure_of(const std::string& work, const JsonAt& said) {
  Json failure{{"work", work}, {"what", one_line(said.at("what").text())}};
  for (const char* key : {"folder", "command"}) {
    if (const auto one = said.find(key)) failure[key] = one_line(one->text());
  }
  return failure;
}

// A line of a failure, and how to see it again.
std::string text_of(const Json& failure) {
  std::string text = fmt::format("FAILED: {}: {}\n", failure.at("work").get<std::string>(),
                                 failure.at("what").get<std::string>());
  if (failure.contains("folder")) {
    text += fmt::format("  kept in: {}\n", failure["folder"].get<std::string>());
  }
  if (failure.contains("command")) {
    text += fmt::format("  again: {} {}\n", program_name(), failure["command"].get<std::string>());
  }
  return text;
}

class Putting {
 public:
  Putting(const RunFolder& run, const Kinds& kinds, const Results& results)
      : run_(run), results_(results), kinds_(kinds) {}

  Report all() {
    Json tasks = Json::array();
    std::size_t w = 0;
    for (std::size_t t = 0; t < run_.plan().tasks.size(); ++t) tasks.push_back(task(t, w));
    Report report;
    report.holds = holds_;
    Json& json = report.json;
    json["format"] = format;
    json["name"] = run_.plan().name;
    json["verdict"] = unfinished_ != 0 ? "unfinished" : holds_ ? "pass" : "fail";
    json["seed"] = run_.plan().seed;
    json["failures"] = failures_;
    json["tasks"] = std::move(tasks);
    for (const Json& failure : failures_) report.text += text_of(failure);
    if (!failures_.empty()) report.text += '\n';
    report.text += lines_;
    report.text +=
        fmt::format("{}: seed {}: {}, {}, {}\nverdict: {}\n", run_.plan().name, run_.plan().seed,
                    count(run_.plan().tasks.size(), "task"), count(failures_.size(), "failure"),
                    unfinished_ == 0 ? "all run" : count(unfinished_, "work") + " unfinished",
                    unfinished_ != 0 ? "UNFINISHED"
                    : holds_         ? "pass"
                                     : "FAIL");
    return report;
  }

 private:
  Json task(std::size_t t, std::size_t& w) {
    const Task& task = run_.plan().tasks[t];
    Json json{{"name", task.name}, {"kind", task.kind}, {"seed", task.seed}};
    json["works"] = Json::array();
    const Works works = run_.works_of(t, kinds_);
    for (const auto& work : works) json["works"].push_back(one(task, *work, w++));
    return json;
  }

  Json one(const Task& task, const Work& work, std::size_t w) {
    std::vector<Part> parts;
    std::size_t failures = 0;
    bool whole = true;
    const std::string title = fmt::format("{}: {}", task.name, work.title());
    const auto& shards = run_.shards();  // in the order of the works
    const auto first = std::ranges::lower_bound(shards, w, {}, &Shard::work);
    for (auto at = first; at != shards.end() && at->work == w; ++at) {
      const Shard& shard = *at;
      const auto s = static_cast<std::size_t>(at - shards.begin());
      if (!results_.done[s]) whole = false;
      if (!whole) break;
      const std::string place = fmt::format("{}: shard {}", (run_.path() / "results").string(), s);
      const JsonAt all = JsonAt::of(place, results_.done[s]->result);
      const auto failed = all.find("failed");
      if (failed) {
        for (const JsonAt& one : failed->list(1)) failures_.push_back(failure_of(title, one));
        ++failures;
      }
      parts.push_back({shard.first, shard.last, all, failed.has_value()});
      if (failures != 0 && work.ends_at_failure()) break;
    }
    const Json result = whole ? work.merged(parts) : Json();
    if (result.contains("failed")) {
      for (const Json& one : result["failed"]) {
        failures_.push_back(failure_of(title, JsonAt::of(title, one)));
        ++failures;
      }
    }
    holds_ = holds_ && whole && failures == 0;
    unfinished_ += whole ? 0 : 1;
    const char* verdict = !whole ? "unfinished" : failures == 0 ? "pass" : "fail";
    lines_ += fmt::format("{:<10} {}, {}\n", verdict, title, count(work.units(), "unit"));
    Json json{{"title", work.title()}, {"verdict", verdict}};
    if (whole) json["result"] = result;
    return json;
  }

  const RunFolder& run_;
  const Results& results_;
  const Kinds& kinds_;
  Json failures_ = Json::array();
  std::string lines_;
  std::size_t unfinished_ = 0;
  bool holds_ = true;
};

}  // namespace

std::vector<bool> ends_at_failure(const RunFolder& run, const Kinds& kinds) {
  std::vector<bool> all;
  for (std::size_t t = 0; t < run.plan().tasks.size(); ++t) {
    for (const auto& work : run.works_of(t, kinds)) all.push_back(work->ends_at_failure());
  }
  return all;
}

std::vector<std::uint64_t> missing(const RunFolder& run, const Results& results,
                                   const std::vector<bool>& ends_at_failure) {
  std::vector<std::uint64_t> all;
  std::vector<bool> over(run.works().size());
  for (std::uint64_t s = 0; s < run.shards().size(); ++s) {
    const std::size_t work = run.shards()[s].work;
    if (!over[work] && !results.done[s]) all.push_back(s);
    over[work] = over[work] || (ends_at_failure[work] && results.failed(s));
  }
  return all;
}

Report report(const RunFolder& run, const Kinds& kinds, const Results& results) {
  return Putting(run, kinds, results).all();
}

void write_report(const RunFolder& run, const Results& results, const Report& report) {
  Json hosts = Json::object();
  double seconds = 0;
  for (const auto& line : results.done) {
    if (!line) continue;
    seconds += line->seconds;
    hosts[line->host] = hosts.value(line->host, 0) + 1;
  }
  const Json times{{"shards", run.shards().size()},
                   {"seconds", seconds},
                   {"hosts", hosts},
                   {"twice", results.twice},
                   {"torn", results.torn}};
  write_file((run.path() / "times.json").string(), json_text(times, 1) + '\n');
  write_file((run.path() / "report.txt").string(), report.text);
  write_file((run.path() / "report.json").string(), json_text(report.json, 1) + '\n');
}

}  // namespace cosim::regress
