// The same work by several algorithms.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tb/designs/circular/design.h"
#include "tb/designs/dda/design.h"
#include "tb/designs/linear/design.h"
#include "tb/sim/bench.h"
#include "tb/sim/sweep.h"
#include "tb/studies/comparison/figures.h"

namespace cosim::compare {

/// The machines at hand; one that the work does not need may be null.
struct Machines {
  const Bench<linear::Design>* linear = nullptr;
  const Bench<circular::Design>* circular = nullptr;
  const Bench<dda::Design>* dda = nullptr;
  std::uint32_t power_up = 1;
};

/// A path as it was drawn.
struct Drawing {
  Points points;             ///< the start, then a point a position
  std::uint64_t clocks = 0;  ///< from the start to the end; a word is one clock
  /// Of a machine: the bench, and what lockstep and the oracle say.
  const AnyBench* bench = nullptr;
  Result result;
};

/// How one algorithm draws one kind of work.
template <class Work>
struct Algorithm {
  std::string name;
  std::string what;  ///< a few words
  std::function<Drawing(const Machines&, const Work&)> draw;
  /// Whether it can do the work; where it is empty, it can do any.
  std::function<bool(const Work&)> can = {};
  std::string cannot = {};  ///< the work that it cannot do, a noun
};

const std::vector<Algorithm<Line>>& line_algorithms();
const std::vector<Algorithm<Arc>>& arc_algorithms();

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
