// A testbench for one design at one set of parameters, its Verilated class hidden behind it: what
// tests and the command line hold.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tb/hostile.h"
#include "tb/replay.h"
#include "tb/run.h"
#include "tb/wave/recorder.h"
#include "tb/wave/wanted.h"

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
  /// The inputs of a clock on which nothing is asked of the machine.
  virtual std::vector<Word> rest() const = 0;
  /// The fields of the model's state, and the state after a clear.
  virtual std::vector<Field> state() const = 0;
  virtual std::vector<Word> cleared() const = 0;
  /// Runs hostile clocks.
  virtual Run run_hostile(const HostileCase& c) const = 0;

  /// Runs a stimulus of this machine, to its end or to the first difference. InputError where it
  /// starts from a state and the machine cannot.
  virtual Run replay(const Stimulus& stimulus, Window window = {}) const = 0;
  /// The same, only to know the first clock that differs.
  virtual std::optional<std::uint64_t> first_difference(const Stimulus& stimulus) const = 0;
  /// Draws `stimulus` in the FST file `path` and the view beside it: the clocks of `around` the
  /// first difference, or all where none differs. InputError where a file cannot be written.
  virtual void draw_wave(const std::string& path, const Stimulus& stimulus,
                         Window around) const = 0;

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
  /// All clocks drawn so far, as a stimulus.
  virtual Stimulus stimulus() const = 0;
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
  /// `bench`, which must outlive the session, is the one it is of.
  AdapterSession(const AnyBench& bench, std::uint32_t power_up)
      : bench_(bench), power_up_(power_up), lockstep_(power_up) {}
  ~AdapterSession() override {
    draw_if_wanted(bench_, [this] { return stimulus(); });
  }

  Run draw(std::span<const Job> jobs, Observer<Design>& observer) override {
    history_.insert(history_.end(), jobs.begin(), jobs.end());
    Host host(Adapter::params, jobs);
    Run result;
    const bool same =
        clock_through(lockstep_, host, result.clocks,
                      [&](const Host& h, const auto& seen) { observer.clock(h.job(), seen); });
    clocks_ += result.clocks;
    if (!same) {
      Lockstep<Adapter> again(power_up_);
      result.mismatch = examine(again, Host(Adapter::params, history_), clocks_ - 1, Window{});
      result.mismatch->bench = &bench_;
      result.mismatch->stimulus.power_up = power_up_;
      result.mismatch->smaller_case = [jobs = history_, power_up = power_up_] {
        return smaller_case<Adapter>(jobs, power_up);
      };
    }
    return result;
  }

  Stimulus stimulus() const override {
    return recorded<Design>(Adapter::params, Host(Adapter::params, history_), power_up_, clocks_);
  }

 private:
  const AnyBench& bench_;
  std::uint32_t power_up_;
  Lockstep<Adapter> lockstep_;
  std::uint64_t clocks_ = 0;
  std::vector<Job> history_;  // to come to the same clock again
};

/// The bench behind an adapter. `Instrumented` is the same adapter on a class that shows its whole
/// hierarchy and whose registers can be loaded: it is for replays and waves.
template <class Adapter, class Instrumented = Adapter>
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
    return fields<typename Design::template Inputs<Word>>();
  }
  std::vector<Field> state() const override {
    return fields<typename Design::template State<Word>>();
  }
  std::vector<Field> compared() const override {
    auto all = fields<typename Design::template Registers<Word>>();
    const auto outputs = fields<typename Design::template Outputs<Word>>();
    all.insert(all.end(), outputs.begin(), outputs.end());
    return all;
  }
  std::size_t registers() const override { return Design::template Registers<Word>::size; }
  std::vector<Word> rest() const override { return words(Design::rest()); }
  std::vector<Word> cleared() const override { return words(Design::template cleared<Word>()); }
  typename Design::Params params() const override { return Adapter::params; }

  Run run_hostile(const HostileCase& c) const override {
    const HostileStimulus<Design> hostile(Adapter::params, c);
    draw_if_wanted(
        *this, [&] { return recorded<Design>(Adapter::params, hostile, c.power_up(), c.clocks); });
    Run result = run<Adapter>(hostile, c.power_up());
    if (result.mismatch) result.mismatch->bench = this;
    return result;
  }
  std::unique_ptr<Session<Design>> open(std::uint32_t power_up) const override {
    return std::make_unique<AdapterSession<Adapter>>(*this, power_up);
  }

  Run replay(const Stimulus& s, Window window) const override {
    Run result = replayed<Instrumented>(s, window);
    if (result.mismatch) result.mismatch->bench = this;
    return result;
  }
  std::optional<std::uint64_t> first_difference(const Stimulus& s) const override {
    // From a clear the class that lockstep runs by does it, and faster.
    return s.state ? differing_clock<Instrumented>(s) : differing_clock<Adapter>(s);
  }
  void draw_wave(const std::string& path, const Stimulus& s, Window around) const override {
    record_wave<Instrumented>(path, s, around,
                              {this->title(), inputs(), compared(), registers(),
                               texts(Design::View::phases), texts(Design::View::steps)});
  }

 private:
  template <class Record>
  static std::vector<Field> fields() {
    const auto list = Record::fields(Adapter::params);
    return {list.begin(), list.end()};
  }
  template <class Record>
  static std::vector<Word> words(const Record& record) {
    const auto list = to_words(record);
    return {list.begin(), list.end()};
  }
  template <class List>
  static std::vector<std::string> texts(const List& list) {
    return {list.begin(), list.end()};
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
