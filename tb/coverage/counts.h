// In a build that measures coverage, lockstep counts a design's bins. In other builds this costs
// nothing.
#pragma once

#include <atomic>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "model/core/bins.h"

namespace cosim::coverage {

#ifdef COSIM_COVERAGE
inline constexpr bool measured = true;
#else
inline constexpr bool measured = false;
#endif

/// A name and how often.
struct Count {
  std::string name;
  std::uint64_t hits = 0;
};

/// A file for `what`, number `number` of this process, in the folder that the environment variable
/// COSIM_COVERAGE names; empty if it is not set: then no counts are written.
std::string file_for(const std::string& what, int number);

/// Writes the counts of a design's bins into such a file, one line a bin.
void leave(const std::string& design, const std::vector<Count>& counts);

/// The counts of a design, written when the process ends.
template <class Adapter>
class Counts {
 public:
  using Design = typename Adapter::Design;

  static void clock(const Moment<Design>& m) {
    static Counts counts;
    for (std::size_t i = 0; i < size; ++i) {
      if (Adapter::bins[i].hit(m)) counts.hits_[i].fetch_add(1, std::memory_order_relaxed);
    }
  }
  ~Counts() {
    std::vector<Count> all;
    for (std::size_t i = 0; i < size; ++i) all.push_back({Adapter::bins[i].name, hits_[i]});
    leave(Design::name, all);
  }

 private:
  static constexpr std::size_t size = std::size(Adapter::bins);
  std::atomic<std::uint64_t> hits_[size]{};
};

/// Counts one clock of an adapter whose design has bins.
template <class Adapter, class Before, class In, class Step>
void count([[maybe_unused]] const Before& before, [[maybe_unused]] const In& in,
           [[maybe_unused]] const Step& step) {
  if constexpr (measured && requires { Adapter::bins; }) {
    Counts<Adapter>::clock({Adapter::params, before, in, step.outputs, step.state});
  }
}

}  // namespace cosim::coverage
