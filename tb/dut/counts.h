// In a build that measures coverage, lockstep counts how often each of a model's cases happens, and
// each way through it is taken. In other builds this costs nothing.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "model/core/design.h"
#include "model/core/stated.h"

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

/// Writes the counts of a design's cases or ways into such a file, one line each.
void leave(const std::string& what, const std::string& design, const std::vector<Count>& counts);

}  // namespace cosim::coverage
#ifdef COSIM_COVERAGE
#include "tb/dut/ways_taken.h"  // which leaves counts
#endif
namespace cosim::coverage {

/// The counts of a design's cases, written when the process ends.
template <class Design, std::size_t n>
class Counts {
 public:
  using Cases = std::array<Stated<Word>, n>;
  static void clock(const Cases& cases) {
    static Counts counts(cases);
    for (std::size_t i = 0; i < n; ++i) {
      if (cases[i].holds) counts.hits_[i].fetch_add(1, std::memory_order_relaxed);
    }
  }
  ~Counts() {
    std::vector<Count> all;
    for (std::size_t i = 0; i < n; ++i) all.push_back({cases_[i].sentence, hits_[i]});
    leave("cases", Design::name, all);
  }

 private:
  explicit Counts(const Cases& cases) : cases_(cases) {}
  Cases cases_;
  std::array<std::atomic<std::uint64_t>, n> hits_{};
};

/// Counts one clock.
template <class Design, class Params, class State, class Inputs>
void count([[maybe_unused]] const Params& p, [[maybe_unused]] const State& s,
           [[maybe_unused]] const Inputs& in) {
  if constexpr (measured) {
    const auto cases = cases_of<Word>(p, s, in);
    constexpr std::size_t n = std::tuple_size_v<std::remove_const_t<decltype(cases)>>;
    if constexpr (n != 0) Counts<Design, n>::clock(cases);
#ifdef COSIM_COVERAGE
    if constexpr (requires { Design::model(p); }) WaysTaken<Design>::clock(p, s, in);
#endif
  }
}

}  // namespace cosim::coverage
