// One job on one machine in lockstep, drawn as the options ask for: cosim line, arc and dda.
#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tb/cli/conclude.h"
#include "tb/cli/wave.h"
#include "tb/output_file.h"
#include "tb/plot/plot.h"
#include "tb/table.h"

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
};

/// Runs it, prints and writes what the options ask for: the exit status.
template <class Design, class Job, class Check>
int draw_one(const OneRun<Design, Job, Check>& one) {
  const Common& common = one.common;
  fmt::print("{}: {}\n", one.bench.title(), one.work);
  Observers<Design> observers{&one.check, &one.rows};
  if (common.plot) observers.add(one.points);
  std::unique_ptr<Table<Design>> table;
  if (common.table) {
    observers.add(*(table = std::make_unique<Table<Design>>(one.bench.params())));
  }

  const auto session = one.bench.open(one.power_up);
  Run run = session->draw({&one.job, 1}, observers);
  one.csv.close();
  if (common.plot) draw_plot(*common.plot, {one.work, {one.ideal()}, {one.path}});
  draw_wave(common, one.bench, one.work, *session, run.mismatch);
  const Outcome outcome = outcome_of(one.bench, one.work, std::move(run), one.check);
  fmt::print("drawn: {}\n", drawn(outcome.result));
  return conclude({outcome}, common);
}

}  // namespace cosim::cli
