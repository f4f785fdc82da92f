// A subject from the adapter that lockstep uses: a mutant is found like any other difference.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tb/bench/design_bench.h"
#include "tb/mutation/cases.h"
#include "tb/mutation/mutants.h"

namespace cosim::mutation {

/// An adapter whose RTL has the input `mutsel`.
template <class Base>
class MutantAdapter : public Base {
 public:
  explicit MutantAdapter(std::uint32_t power_up) : Base(power_up) {
    this->top().mutsel = static_cast<std::uint16_t>(chosen);
  }
  static inline thread_local unsigned chosen = 0;
};

/// `BenchOf`: the bench of an adapter.
template <class Base, template <class...> class BenchOf = FastBench>
class AdapterSubject final : public Subject {
  using Adapter = MutantAdapter<Base>;

 public:
  AdapterSubject(std::string verilog, const std::string& list)
      : Subject(std::move(verilog), list) {}

  const AnyBench& bench() const override { return bench_; }
  void choose(unsigned mutant) const override { Adapter::chosen = mutant; }
  const std::vector<Case>& cases() const override { return cases_; }
  std::size_t quick() const override { return quick_; }

 private:
  BenchOf<Adapter> bench_;
  std::vector<Case> cases_ = quick_cases_of<typename Base::Design>(bench_);
  std::size_t quick_ = add_thorough_cases<typename Base::Design>(cases_, bench_);
};

}  // namespace cosim::mutation
