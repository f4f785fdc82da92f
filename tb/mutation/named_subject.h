// The mutants of a shape whose nets are found by name: in lockstep where its model is a step, with
// random transactions where it is a function of streams.
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

/// Attacked with both.
template <class Top, class Trait>
class BothSubject final : public VerilatedSubject {
 public:
  BothSubject(const std::string& verilog, const std::string& list)
      : VerilatedSubject(verilog, list), clocks_(verilog, list), streams_(verilog, list) {
    const auto add = [&](const Cases& of, bool quick) {
      const auto middle = of.all.begin() + static_cast<std::ptrdiff_t>(of.quick);
      cases_.all.insert(cases_.all.end(), quick ? of.all.begin() : middle,
                        quick ? middle : of.all.end());
    };
    for (const bool quick : {true, false}) {
      add(clocks_.cases(), quick);
      add(streams_.cases(), quick);
      if (quick) cases_.quick = cases_.all.size();
    }
  }

  const AnyBench& bench() const override { return clocks_.bench(); }
  void choose(unsigned mutant) const override {
    clocks_.choose(mutant);
    streams_.choose(mutant);
  }
  const Cases& cases() const override { return cases_; }

 private:
  AdapterSubject<NamedAdapter<Top, Trait>> clocks_;
  StreamSubject<Top, Trait> streams_;
  Cases cases_;
};

/// Top: the Verilated class. `verilog`, `list`: the mutants, as Subject has them.
template <class Top, class Trait>
std::unique_ptr<Subject> named_subject(std::string verilog, const std::string& list) {
  if constexpr (HasStreams<typename Trait::Design> && StepsOn<typename Trait::Design, Word>) {
    return std::make_unique<BothSubject<Top, Trait>>(verilog, list);
  } else if constexpr (HasStreams<typename Trait::Design>) {
    return std::make_unique<StreamSubject<Top, Trait>>(std::move(verilog), list);
  } else {
    return std::make_unique<AdapterSubject<NamedAdapter<Top, Trait>>>(std::move(verilog), list);
  }
}

}  // namespace cosim::mutation
