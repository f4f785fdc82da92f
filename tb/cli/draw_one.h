// One job on one bench, drawn as the options of a command ask for.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tb/bench/table.h"
#include "tb/cli/conclude.h"
#include "tb/cli/extent.h"
#include "tb/cli/progress.h"
#include "tb/cli/wave.h"
#include "tb/plot/plot.h"
#include "tb/support/output_file.h"

namespace cosim::cli {

/// What is drawn, and what watches it.
template <class Design, class Job, class Check>
struct OneRun {
  const Common& common;
  std::uint32_t power_up;  ///< the seed
  const Bench<Design>& bench;
  const std::string& work;  ///< what the job is, in one line
  const Job& job;
  Check& check;
  OutputFile& csv;
  Observer<Design>& rows;        ///< writes into csv
  Series& path;                  ///< for --plot
  Observer<Design>& points;      ///< adds to path
  std::function<Curve()> ideal;  ///< what the path was to be, asked for when it is whole
  Extent extent;
};

/// Says how far a run is, and ends one whose wave could not be drawn.
template <class Design>
class Watch final : public Observer<Design> {
 public:
  Watch(const Common& common, const std::string& title, const Extent& extent)
      : wave_(common.wave), progress_(title, extent.clocks, leaves_terminal(common)) {}
  void clock(std::size_t, const Compared<Design>&) override {
    if (++clocks_ > most_wave_clocks && wave_) check_wave_clocks(clocks_);
    progress_.at(clocks_);
  }
  void finish() { progress_.clear(); }

 private:
  bool wave_;
  std::uint64_t clocks_ = 0;
  RunProgress progress_;
};

/// Runs it, prints and writes what the options ask for: the exit status.
template <class Design, class Job, class Check>
int draw_one(const OneRun<Design, Job, Check>& one) {
  const Common& common = one.common;
  fmt::print("{}: {}\n", one.bench.title(), one.work);
  announce_csv(common, one.extent);
  Watch<Design> watch(common, one.bench.title(), one.extent);
  Observers<Design> observers{&one.check, &one.rows, &watch};
  if (common.plot) observers.add(one.points);
  std::unique_ptr<Table<Design>> table;
  if (common.table) {
    observers.add(*(table = std::make_unique<Table<Design>>(one.bench.params())));
  }

  const auto session = one.bench.open(one.power_up);
  Run run = session->draw({&one.job, 1}, observers);
  watch.finish();
  if (common.plot) draw_plot(*common.plot, {one.work, {one.ideal()}, {one.path}});
  draw_wave(common, one.bench, one.work, *session, run.mismatch);
  one.csv.close();
  const Outcome outcome = outcome_of(one.bench, one.work, std::move(run), one.check);
  fmt::print("drawn: {}\n", drawn(outcome.result));
  return conclude({outcome}, common);
}

}  // namespace cosim::cli
