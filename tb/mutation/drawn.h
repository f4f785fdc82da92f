// Mutants drawn at random of those that lanes killed, for the ordinary lockstep to kill again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "tb/mutation/cases.h"
#include "tb/mutation/mutants.h"
#include "tb/mutation/subject.h"
#include "tb/sim/design_bench.h"

namespace cosim::mutation {

// Mutants in a Verilated class, one at a time, from the adapter that lockstep uses: a mutant is
// found like any other difference.
/// Those of one design at one set of parameters.
class VerilatedMutants {
 public:
  virtual ~VerilatedMutants() = default;
  virtual const AnyBench& bench() const = 0;
  virtual const Cases& cases() const = 0;
  /// Chooses the mutant, from 1, for all machines that the calling thread makes from now on; 0 is
  /// the unchanged RTL.
  virtual void choose(unsigned mutant) const = 0;

  /// Runs these cases on one of them; open where none kills it.
  Outcome attack(unsigned mutant, std::size_t first, std::size_t last) const {
    choose(mutant);
    for (std::size_t i = first; i < last; ++i) {
      const Case& one = cases().all[i];
      const Run run = one.run();
      if (!run.mismatch) continue;
      return {Outcome::End::killed, one.name, run.mismatch->clock, run.mismatch->signal};
    }
    return {};
  }
};

/// An adapter whose RTL has the input `mutsel`. Between a register and its net there may be a
/// mutant: synchronizers take the old value.
template <class Base>
class MutantAdapter : public Base {
 public:
  explicit MutantAdapter(std::uint32_t power_up) : Base(power_up) {
    this->top().mutsel = static_cast<std::uint16_t>(chosen);
  }
  bool turns() const final { return false; }
  static inline thread_local unsigned chosen = 0;
};

template <class Base>
class AdapterMutants final : public VerilatedMutants {
  using Adapter = MutantAdapter<Base>;

 public:
  const AnyBench& bench() const override { return bench_; }
  void choose(unsigned mutant) const override { Adapter::chosen = mutant; }
  const Cases& cases() const override { return cases_; }

 private:
  DesignBench<typename Base::Design> bench_{dut_maker<Adapter>()};
  Cases cases_ = cases_of<typename Base::Design>(bench_);
};

/// Draws `count` mutants that a quick case kills, or all where these are fewer. Writes into the
/// folder mutants.v, which has them, and drawn.json: an array of objects with `mutant`, `what`,
/// `stimulus`, `clock`, `signal`, and `cleared`, false where what a reset leaves depends on how the
/// RTL powered up.
void draw(const Subject& subject, std::size_t count, const std::filesystem::path& folder);

/// Runs the mutants of that list in the Verilated class: each must be killed by the same case, on
/// the same clock, at the same signal; one that is not reset, which powers up otherwise there, by
/// any quick case. Prints the others and how many there were. The exit status.
int check_drawn(const VerilatedMutants& mutants, const std::filesystem::path& folder);

}  // namespace cosim::mutation
