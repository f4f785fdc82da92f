// The mutants of a shape whose nets are found by name: in lockstep where its model is a step, with
// random transactions where it is a function of streams.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tb/mutation/subject.h"
#include "tb/package/named_bench.h"

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

/// Attacked with both.
template <class Top, class Trait>
class BothSubject final : public Subject {
 public:
  BothSubject(const std::string& verilog, const std::string& list)
      : Subject(verilog, list), clocks_(verilog, list), streams_(verilog, list) {
    const std::size_t first = clocks_.quick(), second = streams_.quick();
    add(clocks_, 0, first);
    add(streams_, 0, second);
    quick_ = cases_.size();
    add(clocks_, first, clocks_.cases().size());
    add(streams_, second, streams_.cases().size());
  }

  const AnyBench& bench() const override { return clocks_.bench(); }
  void choose(unsigned mutant) const override {
    clocks_.choose(mutant);
    streams_.choose(mutant);
  }
  const std::vector<Case>& cases() const override { return cases_; }
  std::size_t quick() const override { return quick_; }

 private:
  void add(const Subject& of, std::size_t begin, std::size_t end) {
    const auto all = of.cases().begin();
    cases_.insert(cases_.end(), all + static_cast<std::ptrdiff_t>(begin),
                  all + static_cast<std::ptrdiff_t>(end));
  }

  AdapterSubject<NamedAdapter<Top, Trait>, AdapterBench> clocks_;
  StreamSubject<Top, Trait> streams_;
  std::vector<Case> cases_;
  std::size_t quick_ = 0;
};

/// Top: the Verilated class. `verilog`, `list`: the mutants, as Subject has them.
template <class Top, class Trait>
std::unique_ptr<Subject> named_subject(std::string verilog, const std::string& list) {
  if constexpr (HasStreams<typename Trait::Design> && StepsOn<typename Trait::Design, Word>) {
    return std::make_unique<BothSubject<Top, Trait>>(verilog, list);
  } else if constexpr (HasStreams<typename Trait::Design>) {
    return std::make_unique<StreamSubject<Top, Trait>>(std::move(verilog), list);
  } else {
    return std::make_unique<AdapterSubject<NamedAdapter<Top, Trait>, AdapterBench>>(
        std::move(verilog), list);
  }
}

}  // namespace cosim::mutation
