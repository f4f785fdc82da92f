// A testbench for one design at one set of parameters, its Verilated class hidden behind it: what
// tests and the command line hold.
#pragma once

#include <cstdint>
#include <initializer_list>
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
  /// How many of them are registers.
  virtual std::size_t registers() const = 0;
  virtual std::vector<Field> inputs() const = 0;
  /// Runs hostile clocks.
  virtual Run run_hostile(const HostileCase& c) const = 0;

  /// "linear M=5 N=2"
  std::string title() const;
};

/// What a caller wants to see of a run of jobs: registers and outputs on every clock that matched,
/// and the job they belong to.
template <class Design>
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void clock(std::size_t job, const Compared<Design>& seen) = 0;
};

/// Several observers as one; they must outlive it.
template <class Design>
class Observers final : public Observer<Design> {
 public:
  Observers(std::initializer_list<Observer<Design>*> list) : list_(list) {}
  void add(Observer<Design>& one) { list_.push_back(&one); }
  void clock(std::size_t job, const Compared<Design>& seen) override {
    for (Observer<Design>* one : list_) one->clock(job, seen);
  }

 private:
  std::vector<Observer<Design>*> list_;
};

/// One machine in lockstep, at work for as long as the caller has jobs.
template <class Design>
class Session {
 public:
  using Job = typename Design::Host::Job;
  virtual ~Session() = default;
  /// Has the design's host draw the jobs one after the other, to their end or to the first
  /// difference; after a difference the session is over. Clocks of a Run count from this call, the
  /// clock of a Mismatch from the session's start.
  virtual Run draw(std::span<const Job> jobs, Observer<Design>& observer) = 0;
};

template <class Design>
class Bench : public AnyBench {
 public:
  virtual typename Design::Params params() const = 0;
  /// A machine of its own, powered up at random from `power_up`.
  virtual std::unique_ptr<Session<Design>> open(std::uint32_t power_up) const = 0;
};

template <class Adapter>
class AdapterSession final : public Session<typename Adapter::Design> {
  using Design = typename Adapter::Design;
  using Host = typename Design::Host;
  using Job = typename Host::Job;

 public:
  explicit AdapterSession(std::uint32_t power_up) : power_up_(power_up), lockstep_(power_up) {}

  Run draw(std::span<const Job> jobs, Observer<Design>& observer) override {
    history_.insert(history_.end(), jobs.begin(), jobs.end());
    Host host(Adapter::params, jobs);
    Run result;
    const bool same =
        clock_through(lockstep_, host, result.clocks,
                      [&](const Host& h, const auto& seen) { observer.clock(h.job(), seen); });
    clocks_ += result.clocks;
    if (!same) {
      result.mismatch =
          examine<Adapter>(Host(Adapter::params, history_), power_up_, clocks_ - 1, Window{});
    }
    return result;
  }

 private:
  std::uint32_t power_up_;
  Lockstep<Adapter> lockstep_;
  std::uint64_t clocks_ = 0;
  std::vector<Job> history_;  // to come to the same clock again
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
  std::size_t registers() const override { return Design::template Registers<Word>::size; }
  typename Design::Params params() const override { return Adapter::params; }

  Run run_hostile(const HostileCase& c) const override {
    return run<Adapter>(HostileStimulus<Design>(Adapter::params, c), c.power_up());
  }
  std::unique_ptr<Session<Design>> open(std::uint32_t power_up) const override {
    return std::make_unique<AdapterSession<Adapter>>(power_up);
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
