// Mutants in a Verilated class, one at a time, from the adapter that lockstep uses: a mutant is
// found like any other difference.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tb/bench/design_bench.h"
#include "tb/mutation/cases.h"
#include "tb/mutation/mutants.h"

namespace cosim::mutation {

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

}  // namespace cosim::mutation
