// A testbench for one design at one set of parameters, its Verilated class hidden behind it: what
// tests and the command line hold.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tb/hostile.h"
#include "tb/run.h"

namespace cosim {

/// What every bench can say of itself.
class AnyBench {
 public:
  AnyBench() = default;
  AnyBench(const AnyBench&) = delete;
  AnyBench& operator=(const AnyBench&) = delete;
  virtual ~AnyBench() = default;

  virtual std::string design() const = 0;
  virtual std::string source() const = 0;
  virtual std::vector<Parameter> parameters() const = 0;
  /// The registers and outputs compared on every clock, registers first.
  virtual std::vector<Field> compared() const = 0;
  virtual std::vector<Field> inputs() const = 0;
  /// Runs hostile clocks.
  virtual Run run_hostile(const HostileCase& c) const = 0;

  /// "linear M=5 N=2"
  std::string title() const;
};

/// What a caller wants to see of a run of jobs: the model's outputs on every clock, which are the
/// RTL's too, and the job they belong to.
template <class Design>
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void clock(std::size_t job, const typename Design::template Outputs<Word>& out) = 0;
};

template <class Design>
class Bench : public AnyBench {
 public:
  virtual typename Design::Params params() const = 0;
  /// Has the design's host draw the jobs one after the other on one machine.
  virtual Run run_jobs(std::span<const typename Design::Host::Job> jobs, std::uint32_t power_up,
                       Observer<Design>& observer) const = 0;
};

/// The bench behind an adapter.
template <class Adapter>
class AdapterBench final : public Bench<typename Adapter::Design> {
  using Design = typename Adapter::Design;

 public:
  std::string design() const override { return Design::name; }
  std::string source() const override { return Design::source; }
  std::vector<Parameter> parameters() const override {
    const auto list = Design::parameters(Adapter::params);
    return {list.begin(), list.end()};
  }
  std::vector<Field> inputs() const override {
    const auto list = Design::template Inputs<Word>::fields(Adapter::params);
    return {list.begin(), list.end()};
  }
  std::vector<Field> compared() const override {
    const auto registers = Design::template Registers<Word>::fields(Adapter::params);
    const auto outputs = Design::template Outputs<Word>::fields(Adapter::params);
    std::vector<Field> all(registers.begin(), registers.end());
    all.insert(all.end(), outputs.begin(), outputs.end());
    return all;
  }
  typename Design::Params params() const override { return Adapter::params; }

  Run run_hostile(const HostileCase& c) const override {
    const auto power_up = static_cast<std::uint32_t>(Random::for_case(~c.seed, c.index).next());
    return run<Adapter>(HostileStimulus<Design>(Adapter::params, c), power_up,
                        [](const auto&, const auto&) {});
  }
  Run run_jobs(std::span<const typename Design::Host::Job> jobs, std::uint32_t power_up,
               Observer<Design>& observer) const override {
    return run<Adapter>(typename Design::Host(Adapter::params, jobs), power_up,
                        [&](const auto& host, const auto& out) { observer.clock(host.job(), out); });
  }
};

/// Every bench that was built, in the order of rtl/shipped.txt.
const std::vector<std::unique_ptr<AnyBench>>& benches();

/// The benches of one design.
template <class Design>
std::vector<const Bench<Design>*> benches_of() {
  std::vector<const Bench<Design>*> found;
  for (const auto& bench : benches()) {
    if (const auto* typed = dynamic_cast<const Bench<Design>*>(bench.get())) found.push_back(typed);
  }
  return found;
}

}  // namespace cosim
