// The mutants of a shape whose nets are found by name: of streams where its model is a function of
// streams, else in lockstep.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tb/bench/named_bench.h"
#include "tb/mutation/subject.h"

namespace cosim::mutation {

/// An instance of RTL that has the input `mutsel`.
template <class Top>
class MutantStreamDut final : public VerilatedStreamDut<Top> {
 public:
  explicit MutantStreamDut(std::uint32_t power_up) : VerilatedStreamDut<Top>(power_up) {
    this->top().mutsel = static_cast<std::uint16_t>(chosen);
  }
  std::vector<Net> nets(const Ports& ports) override {
    Ports with = ports;
    with.extra = "mutsel";
    return VerilatedStreamDut<Top>::nets(with);
  }
  static inline thread_local unsigned chosen = 0;
};

/// Attacked with random transactions alone.
template <class Top, class Trait>
class StreamSubject final : public Subject {
 public:
  StreamSubject(std::string verilog, const std::string& list) : Subject(std::move(verilog), list) {
    for (std::uint64_t i = 0; i < thorough_cases; ++i) {
      cases_.push_back({fmt::format("random transactions, case {}", i), [this, i] {
                          return bench_.run_hostile(HostileCase{seed, i, 1000});
                        }});
    }
  }

  const AnyBench& bench() const override { return bench_; }
  void choose(unsigned mutant) const override { MutantStreamDut<Top>::chosen = mutant; }
  const std::vector<Case>& cases() const override { return cases_; }
  std::size_t quick() const override { return quick_cases; }

 private:
  StreamBench<Top, Trait, MutantStreamDut<Top>> bench_;
  std::vector<Case> cases_;
};

/// Top: the Verilated class. `verilog`, `list`: the mutants, as Subject has them.
template <class Top, class Trait>
std::unique_ptr<Subject> named_subject(std::string verilog, const std::string& list) {
  if constexpr (HasStreams<typename Trait::Design>) {
    return std::make_unique<StreamSubject<Top, Trait>>(std::move(verilog), list);
  } else {
    return std::make_unique<AdapterSubject<NamedAdapter<Top, Trait>, AdapterBench>>(
        std::move(verilog), list);
  }
}

}  // namespace cosim::mutation
