// One job on one bench, drawn as the options of a command ask for.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tb/cli/conclude.h"
#include "tb/cli/draw_steps.h"
#include "tb/cli/extent.h"
#include "tb/cli/outputs.h"
#include "tb/cli/wave.h"
#include "tb/show/plot.h"
#include "tb/sim/job_check.h"
#include "tb/sim/table.h"
#include "tb/sweep/progress.h"
#include "tb/util/output_file.h"

namespace cosim::cli {

/// What is drawn, and what is asked of it.
template <class Design>
struct OneRun {
  const Common& common;
  std::uint32_t power_up;  ///< the seed
  const Bench<Design>& bench;
  std::string work;  ///< what the job is, in one line
  const typename HostOf<Design>::Job& job;
  Extent extent;
  /// Makes what writes the rows of --csv.
  std::function<std::unique_ptr<Observer<Design>>(OutputFile&)> rows;
  GridPoint from;
  std::function<double(GridPoint)> off;  ///< how far a point is off the curve, in steps
  /// The curve that the whole path was to follow.
  std::function<Curve(const std::vector<Mark>&)> ideal;
};

/// Shows how far a run is, and ends a run that is too long for its wave.
template <class Design>
class Watch final : public Observer<Design> {
 public:
  Watch(const Common& common, const std::string& title, const Extent& extent)
      : common_(common), progress_(title, extent.clocks, leaves_terminal(common)) {}
  void clock(std::size_t, const Compared<Design>&) override {
    if (++clocks_ > most_wave_clocks) check_wave_clocks(common_, clocks_);
    progress_.at(clocks_);
  }
  void finish() { progress_.clear(); }

 private:
  const Common& common_;
  std::uint64_t clocks_ = 0;
  RunProgress progress_;
};

/// Runs it, prints and writes what the options ask for: the exit status. Figures as JobCheck has
/// them.
template <class Design, class Figures>
int draw_one(const OneRun<Design>& one) {
  const Common& common = one.common;
  const Bench<Design>& bench = one.bench;
  check_extent(common, one.extent);
  check_outputs(common, {}, {&bench});
  OutputFile csv(common.csv.value_or(""));
  const auto rows = one.rows(csv);
  Series path{bench.title(), {}};
  StepPoints<Design> points(bench.params(), path, one.from, one.off);

  fmt::print("{}: {}\n", bench.title(), one.work);
  announce_csv(common, one.extent);
  Watch<Design> watch(common, bench.title(), one.extent);
  JobCheck<Design, Figures> check(bench.params(), {&one.job, 1});
  Observers<Design> observers{&check, rows.get(), &watch};
  if (common.plot) observers.add(points);
  std::unique_ptr<Table<Design>> table;
  if (common.table) observers.add(*(table = std::make_unique<Table<Design>>(bench.params())));

  const auto session = bench.open(one.power_up);
  Run run = session->draw({&one.job, 1}, observers);
  watch.finish();
  if (common.plot) draw_plot(*common.plot, {one.work, {one.ideal(path.marks)}, {path}});
  const Looks looks = draw_wave(common, bench, one.work, *session, run.mismatch);
  csv.close();
  const Outcome outcome = outcome_of(bench, one.work, std::move(run), check);
  fmt::print("drawn: {}\n", measured_text(outcome.result));
  return conclude({outcome}, common, "{}", looks);
}

}  // namespace cosim::cli
