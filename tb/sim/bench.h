// A testbench for one design at one set of parameters. It hides the Verilated class from tests and
// from the command line.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

#include "model/core/job.h"
#include "model/core/probe.h"
#include "tb/dut/dut.h"
#include "tb/sim/by_hand.h"
#include "tb/sim/checked.h"
#include "tb/sim/hostile.h"
#include "tb/sim/list.h"
#include "tb/sim/run.h"

namespace cosim {

/// Declared jobs, each the values of its fields.
using JobList = std::vector<std::vector<Word>>;

/// What came of them.
struct JobsRun {
  Run run;
  Checked checked;
};

class LaneJobs;
class WaveSink;
struct WavePicture;

/// A clock of RTL and model in lockstep on which they were the same.
struct Watched {
  std::vector<Word> inputs;       ///< in the order of their table
  std::vector<Word> expected;     ///< codes, of registers and outputs as in compared()
  std::vector<bool> is_compared;  ///< which of these mean something on this clock
};
/// Sees clock after clock; false where it has seen enough.
using Watch = std::function<bool(const Watched&)>;

/// The inputs that reset a machine, or those at rest where it begins at its initial values, and on
/// how many clocks they are given before the first that is compared.
struct ResetInputs {
  std::vector<Word> inputs;
  int clocks = 0;
};

/// What the tables of a design say at one set of parameters, without its types.
struct BenchTables {
  std::string design, source;
  std::type_index model = typeid(void);  ///< the struct that is its golden model
  std::vector<Parameter> parameters;
  /// What of the design it looks at, where another bench of the same RTL looks at the rest; else
  /// "".
  std::string view;
  /// The registers and outputs compared on every clock, registers first, and how many these are.
  std::vector<Field> compared;
  std::size_t registers = 0;
  std::string compared_text;  ///< all that is compared, in words
  /// Those that go in, then those that come out; none where clocks are compared.
  std::vector<StreamName> streams;
  std::vector<std::string> cases;  ///< what may happen to a transaction, "STREAM: SENTENCE"
  bool has_programs = false;       ///< its model reads files: program()
  std::vector<Field> inputs;
  const char* row = "clock";         ///< what a row of a stimulus is, a noun
  std::vector<std::string> assumed;  ///< of the inputs, sentences
  std::vector<Probe> probes;         ///< what a wave shows beside the fields
  std::vector<Word> rest;            ///< the inputs of an idle clock
  /// The fields of the model's state, and the state after a reset.
  std::vector<Field> state;
  std::vector<Word> reset_state;
  ResetInputs reset_inputs;
  std::string hostile_text;          ///< what hostile clocks are, in words
  std::string hostile_rows;          ///< and so many of them: "hostile clocks"
  std::vector<JobField> job_fields;  ///< of a job, where jobs are declared by a table (job.h)
};

/// What every bench can say of itself.
class AnyBench {
 public:
  AnyBench() = default;
  AnyBench(const AnyBench&) = delete;
  AnyBench& operator=(const AnyBench&) = delete;
  virtual ~AnyBench() = default;

  const BenchTables& tables() const { return tables_; }
  // BenchTables says what each is.
  const std::string& design() const { return tables_.design; }
  const std::string& source() const { return tables_.source; }
  std::type_index model() const { return tables_.model; }
  const std::vector<Parameter>& parameters() const { return tables_.parameters; }
  const std::string& view() const { return tables_.view; }
  const std::vector<Field>& compared() const { return tables_.compared; }
  std::size_t registers() const { return tables_.registers; }
  const std::string& compared_text() const { return tables_.compared_text; }
  const std::vector<Field>& inputs() const { return tables_.inputs; }
  const std::vector<StreamName>& streams() const { return tables_.streams; }
  const std::vector<std::string>& cases() const { return tables_.cases; }
  bool has_programs() const { return tables_.has_programs; }
  const char* row() const { return tables_.row; }
  const std::vector<std::string>& assumed() const { return tables_.assumed; }
  const std::vector<Probe>& probes() const { return tables_.probes; }
  const std::vector<Word>& rest() const { return tables_.rest; }
  const std::vector<Field>& state() const { return tables_.state; }
  const std::vector<Word>& reset_state() const { return tables_.reset_state; }
  const ResetInputs& reset_inputs() const { return tables_.reset_inputs; }
  const std::string& hostile_text() const { return tables_.hostile_text; }
  const std::vector<JobField>& job_fields() const { return tables_.job_fields; }
  /// Registers and outputs of the RTL that are not compared, by their paths, and as the model names
  /// them.
  const std::vector<std::string>& unobserved() const { return unobserved_; }
  const std::vector<std::string>& patterns() const { return patterns_; }
  void set_unobserved(std::vector<std::string> signals, std::vector<std::string> patterns) {
    unobserved_ = std::move(signals);
    patterns_ = std::move(patterns);
  }

  /// One clock with these inputs from that state, and one with as little to do as is legal, so that
  /// a difference after the first shows.
  virtual Stimulus clock_from(const std::vector<Word>& /*state*/,
                              const std::vector<Word>& /*inputs*/) const {
    return {};
  }
  /// What the RTL's registers hold when a case begins, on a machine powered up at random from
  /// `power_up`: after a reset, or initially.
  virtual std::vector<Word> begun(std::uint32_t /*power_up*/) const { return {}; }
  /// One case of hostile clocks, in words.
  std::string text_of(const HostileCase& c) const;
  /// Runs them.
  virtual Run run_hostile(const HostileCase& c) const = 0;
  /// The inputs of these, as a stimulus. InputError of a bench that cannot tell them before.
  virtual Stimulus hostile(const HostileCase& c) const;
  /// Runs them before `watch`, as far as it wants. InputError where RTL and model differ.
  virtual void watch_hostile(const HostileCase& /*c*/, const Watch& /*watch*/) const {}
  /// Runs a stimulus that starts from a reset, likewise.
  virtual void watch_stimulus(const Stimulus& /*s*/, const Watch& /*watch*/) const {}

  /// "idle=3 byte=65; idle=0 byte=1"
  virtual std::string describe(const JobList& /*jobs*/) const { return {}; }
  /// Drives declared jobs one after the other on a machine powered up at random from `power_up`,
  /// to their end or to the first difference.
  virtual JobsRun run_jobs(const JobList& /*jobs*/, std::uint32_t /*power_up*/) const { return {}; }
  /// Those of many cases, for lanes; jobs(i) are the jobs of case i.
  virtual std::shared_ptr<const LaneJobs> lane_jobs(
      std::function<JobList(std::uint64_t i)> /*jobs*/) const {
    return {};
  }
  /// The same before `watch`, as watch_hostile().
  virtual void watch_jobs(const JobList& /*jobs*/, std::uint32_t /*power_up*/,
                          const Watch& /*watch*/) const {}
  /// The inputs of these, as a stimulus.
  virtual Stimulus stimulus_of(const JobList& /*jobs*/, std::uint32_t /*power_up*/) const {
    return {};
  }

  /// RTL and model for a test by hand, on a machine powered up at random from `power_up`: a
  /// ByHand<Design>; null where what is compared is not clocks.
  virtual std::unique_ptr<AnyByHand> by_hand(std::uint32_t /*power_up*/) const { return {}; }

  /// How the fields of random transactions are distributed, some lines; empty of a bench that has
  /// none.
  virtual std::string drawn_text(std::uint64_t /*seed*/) const { return {}; }

  /// What the model reads from the file `path`, with random stalls. `wrong`: what the program in it
  /// finds wrong by itself, one line, or empty. InputError where it cannot be read.
  virtual Stimulus program(const std::string& /*path*/, std::uint64_t /*seed*/,
                           std::string& /*wrong*/) const {
    return {};
  }

  /// Makes what replays and waves need besides, which they do themselves where it is missing: for
  /// where there is no compiler later. InputError where that fails.
  virtual void prepare_replays() const {}
  /// Runs a stimulus of this machine, to its end or to the first difference. InputError if it
  /// starts from a state and the machine cannot be set to one.
  virtual Run replay(const Stimulus& stimulus, Window window = {}) const = 0;
  /// Runs it too, but finds only the first clock that differs; none where a clock before it breaks
  /// a rule of the design.
  virtual std::optional<std::uint64_t> first_difference(const Stimulus& stimulus) const = 0;
  /// The rows of a stimulus without row n in ways of the bench's own, for shrinking; none where it
  /// is nothing but left out.
  virtual std::vector<std::vector<std::vector<Word>>> without(
      const std::vector<std::vector<Word>>& /*rows*/, std::size_t /*n*/) const {
    return {};
  }
  /// Runs a stimulus, which has a clock at least, and shows it to `sink`: the clocks of `around`
  /// the first difference, or all where none differs.
  virtual void show(const Stimulus& stimulus, Window around, WaveSink& sink) const = 0;
  /// Draws it in the FST file `path` and the view beside it, and for a page; for that alone where
  /// the path is empty. InputError where a file cannot be written.
  WavePicture draw_wave(const std::string& path, const Stimulus& stimulus, Window around) const;

  /// "NAME M=5 N=2": the design and its parameters, as its RTL was built.
  std::string built_as() const;
  /// The same, and the view.
  std::string title() const;

 protected:
  BenchTables tables_;

 private:
  std::vector<std::string> unobserved_, patterns_;
};

/// InputError if it was not built as `shape`, what the RTL was built as: its model has other
/// parameters, or the same in another order.
void require_shape(const AnyBench& bench, const std::string& shape);

/// Sees registers and outputs on every clock that matched, and the number of the job they belong
/// to.
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

/// One machine in lockstep that draws jobs as they come.
template <class Design>
class Session {
 public:
  using Job = typename HostOf<Design>::Job;
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
  /// Draws jobs on such a machine before `watch`, as watch_hostile().
  virtual void watch_drawn(std::span<const typename Session<Design>::Job> jobs,
                           std::uint32_t power_up, const Watch& watch) const = 0;
  /// RTL and model that were just reset, to be clocked by hand.
  virtual std::unique_ptr<AnyLockstep<Design>> lockstep(std::uint32_t power_up) const = 0;
  /// The DUT alone, without a model.
  virtual std::unique_ptr<Dut<Design>> dut(std::uint32_t power_up) const = 0;
};

/// A design that was built and cannot be used. The first call of benches(), which is without it,
/// finds that.
struct Unusable {
  std::string design;
  std::string why;  ///< one line
};
const std::vector<Unusable>& unusable();
/// Has `add` add the benches of a design. Where that is an InputError, which begins with the
/// design's name, none is added, but the design to unusable().
void add_benches(std::vector<std::unique_ptr<AnyBench>>& all,
                 void (*add)(std::vector<std::unique_ptr<AnyBench>>&));

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
