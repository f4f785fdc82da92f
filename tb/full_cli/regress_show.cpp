#include "tb/full_cli/regress_show.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "tb/regress/worker.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

// "50 s", "12 min", "3.5 h"
std::string duration(double minutes) {
  if (minutes < 1.5) return fmt::format("{:.0f} s", 60 * minutes);
  return minutes < 120 ? fmt::format("{:.0f} min", minutes) : fmt::format("{:.1f} h", minutes / 60);
}

}  // namespace

std::string dry_run_text(const regress::Plan& plan, const std::vector<regress::Known>& works,
                         std::uint64_t shards, unsigned jobs) {
  const auto cuts = regress::cut(regress::sizes(works), shards);
  std::string text = fmt::format("{}: seed {}\n{:>12} {:>7} {:>8}  work\n", plan.name, plan.seed,
                                 "units", "shards", "time");
  double minutes = 0;
  for (std::size_t w = 0; w < works.size(); ++w) {
    const regress::Size& size = works[w].size;
    const auto parts = std::ranges::count(cuts, w, &regress::Shard::work);
    text += fmt::format("{:>12} {:>7} {:>8}  {}: {}\n", size.units, parts, duration(size.minutes),
                        plan.tasks[works[w].task].name, works[w].title);
    minutes += size.minutes;
  }
  return text + fmt::format("{}, {}: thought to take {} of processor time, {} on {}\n",
                            count(works.size(), "work"), count(cuts.size(), "shard"),
                            duration(minutes), duration(minutes / jobs), count(jobs, "core"));
}

RegressProgress::RegressProgress() : terminal_(isatty(STDOUT_FILENO) == 1) {}

std::string RegressProgress::text(const regress::Tally& t) const {
  std::string text = fmt::format("{} of {} done, {} running, {} waiting, {} failed", t.done,
                                 count(t.shards, "shard"), t.running, t.waiting(), t.failed);
  if (t.errors != 0) text += fmt::format(", {} could not be run", t.errors);
  const std::chrono::duration<double, std::ratio<60>> gone = Time::now() - began_;
  const double done = t.done_minutes - minutes_before_;
  if (done > 0) {
    text += ", " + duration(gone.count() * (t.minutes - t.done_minutes) / done) + " left";
  }
  return text;
}

void RegressProgress::show(const regress::Tally& tally) {
  if (minutes_before_ < 0) minutes_before_ = tally.done_minutes;
  if (terminal_) {
    fmt::print("\r{:.79}\x1b[K", text(tally));
    drawn_ = true;
  } else if (tally.failed > failed_ || Time::now() >= due_) {
    fmt::print("{}\n", text(tally));
    due_ = Time::now() + std::chrono::minutes(1);
  }
  failed_ = tally.failed;
  std::fflush(stdout);
}

void RegressProgress::clear() {
  if (drawn_) fmt::print("\r\x1b[K");
  drawn_ = false;
}

std::vector<std::string> lines_of(const regress::Errors& errors) {
  std::map<std::string, std::vector<std::uint64_t>> by_text;
  for (const auto& [shard, text] : errors) by_text[text].push_back(shard);
  std::vector<std::string> lines;
  for (const auto& [text, shards] : by_text) {
    lines.push_back(fmt::format("shard{} {}: {}", shards.size() == 1 ? "" : "s",
                                regress::list_of(shards), text));
  }
  return lines;
}

}  // namespace cosim::cli
