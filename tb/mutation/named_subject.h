// The mutants of a shape whose model is a function of streams alone: random transactions. Where
// there is a step beside it they run in lanes, which compare every register of its table on every
// clock.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tb/mutation/subject.h"
#include "tb/package/named_bench.h"
#include "tb/stream/stream_bench.h"

namespace cosim::mutation {

/// An instance of RTL that has the input `mutsel`.
template <class Top>
class MutantStreamDut final : public VerilatedStreamDut<Top> {
 public:
  explicit MutantStreamDut(std::uint32_t power_up) : VerilatedStreamDut<Top>(power_up) {
    this->top().mutsel = static_cast<std::uint16_t>(chosen);
  }
  bool restart(std::uint32_t power_up) override {
    const bool can = VerilatedStreamDut<Top>::restart(power_up);
    this->top().mutsel = static_cast<std::uint16_t>(chosen);
    return can;
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
class StreamSubject final : public VerilatedSubject {
 public:
  StreamSubject(std::string verilog, const std::string& list)
      : VerilatedSubject(std::move(verilog), list) {
    for (std::uint64_t i = 0; i < thorough_cases; ++i) {
      cases_.all.push_back({fmt::format("random transactions, case {}", i), [this, i] {
                              return bench_.run_hostile(HostileCase{campaign_seed, i, 1000});
                            }});
    }
    cases_.quick = quick_cases;
  }

  const AnyBench& bench() const override { return bench_; }
  void choose(unsigned mutant) const override { MutantStreamDut<Top>::chosen = mutant; }
  const Cases& cases() const override { return cases_; }

 private:
  StreamBench<Trait, MutantStreamDut<Top>> bench_;
  Cases cases_;
};

}  // namespace cosim::mutation
