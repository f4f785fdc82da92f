// In a build that measures coverage, lockstep counts a design's bins: those that it declares for
// that (bins.h), or its cases. In other builds this costs nothing.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/core/bins.h"
#include "model/core/design.h"
#include "model/core/stated.h"

namespace cosim::coverage {

#ifdef COSIM_COVERAGE
inline constexpr bool measured = true;
#else
inline constexpr bool measured = false;
#endif
// Defined where a design is one header, so that its cases are seen wherever it is.
#ifdef COSIM_COVERAGE_OF_CASES
inline constexpr bool cases_are_bins = true;
#else
inline constexpr bool cases_are_bins = false;
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

/// Each bin of an adapter's design, and whether it is hit on a clock.
template <class Adapter, class Params, class Before, class In, class Step>
auto bins_of([[maybe_unused]] const Params& p, [[maybe_unused]] const Before& before,
             [[maybe_unused]] const In& in, [[maybe_unused]] const Step& step) {
  using Design = typename Adapter::Design;
  if constexpr (requires { declared_bins(static_cast<const Design*>(nullptr)); }) {
    constexpr const auto& bins = declared_bins(static_cast<const Design*>(nullptr));
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      const Moment<Design> m{p, before, in, step.outputs, step.state};
      return std::array{Stated<Word>{bins[I].name, bins[I].hit(m)}...};
    }
    (std::make_index_sequence<std::size(bins)>());
  } else if constexpr (cases_are_bins) {
    return cases_of<Word>(p, before, in);
  } else {
    return std::array<Stated<Word>, 0>{};
  }
}

/// The counts of a design's bins, written when the process ends.
template <class Design, class Bins>
class Counts {
 public:
  static void clock(const Bins& bins) {
    static Counts counts(bins);
    for (std::size_t i = 0; i < bins.size(); ++i) {
      if (bins[i].holds) counts.hits_[i].fetch_add(1, std::memory_order_relaxed);
    }
  }
  ~Counts() {
    std::vector<Count> all;
    for (std::size_t i = 0; i < bins_.size(); ++i) all.push_back({bins_[i].sentence, hits_[i]});
    leave(Design::name, all);
  }

 private:
  explicit Counts(const Bins& bins) : bins_(bins) {}
  Bins bins_;
  std::array<std::atomic<std::uint64_t>, std::tuple_size_v<Bins>> hits_{};
};

/// Counts one clock.
template <class Adapter, class Params, class Before, class In, class Step>
void count([[maybe_unused]] const Params& p, [[maybe_unused]] const Before& before,
           [[maybe_unused]] const In& in, [[maybe_unused]] const Step& step) {
  if constexpr (measured) {
    const auto bins = bins_of<Adapter>(p, before, in, step);
    if constexpr (std::tuple_size_v<std::remove_const_t<decltype(bins)>> != 0) {
      Counts<typename Adapter::Design, std::remove_const_t<decltype(bins)>>::clock(bins);
    }
  }
}

}  // namespace cosim::coverage
