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
    if (entry.bench != nullptr) add(entry.result, std::move(drawing.result));
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
