// The same work by several algorithms.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/studies/comparison/algorithms.h"

namespace cosim::compare {

/// What came of one algorithm over all the work.
struct Entry {
  std::string name;
  Figures figures;
  const AnyBench* bench = nullptr;  ///< of a machine
  Result result;                    ///< of its runs, added up; the first that does not match
};

/// Called with the number of each work, from 0, and its points.
using PointsSink = std::function<void(std::size_t, const Points&)>;

/// Lines or arcs, drawn one after the other.
template <class Work>
Entry entry_of(const Algorithm<Work>& algorithm, const Machines& machines,
               const std::vector<Work>& works, const PointsSink& sink = {}) {
  Entry entry;
  entry.name = algorithm.name;
  for (std::size_t i = 0; i < works.size(); ++i) {
    const Work& work = works[i];
    Drawing drawing = algorithm.draw(machines, work);
    entry.bench = drawing.bench;
    if (entry.bench != nullptr) {
      Result& sum = entry.result;
      sum.cases += drawing.result.cases;
      sum.clocks += drawing.result.clocks;
      sum.checked.jobs += drawing.result.checked.jobs;
      sum.checked.steps += drawing.result.checked.steps;
      sum.checked.max_deviation =
          std::max(sum.checked.max_deviation, drawing.result.checked.max_deviation);
      sum.checked.error = drawing.result.checked.error;
      sum.mismatch = std::move(drawing.result.mismatch);
    }
    entry.figures.add(measured(work, drawing.points, drawing.clocks));
    if (sink) sink(i, drawing.points);
    if (!entry.result.match()) break;
  }
  return entry;
}

/// The figures of all entries as a table, a line each; lines end in '\n'.
std::string to_text(const std::vector<Entry>& entries);

/// The same as JSON, an array of objects.
std::string to_json(const std::vector<Entry>& entries);

}  // namespace cosim::compare
