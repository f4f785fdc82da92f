// The bench of any shape. Hostile clocks and jobs run for long: where it pays they are compiled for
// each shape (FastBench). Everything else is compiled once for a design.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tb/bench/bench.h"
#include "tb/bench/job_check.h"
#include "tb/bench/lane_jobs.h"
#include "tb/bench/loop.h"
#include "tb/bench/wanted.h"
#include "tb/lockstep/replay.h"
#include "tb/wave/recorder.h"

namespace cosim {

/// A bench whose RTL is what `dut` makes. `instrumented` makes the same with its whole hierarchy
/// open and with registers that can be loaded, for replays and waves.
template <class Design>
class DesignBench : public Bench<Design> {
  using Host = HostOf<Design>;
  using Job = typename Host::Job;

 public:
  explicit DesignBench(const DutMaker<Design>& dut) : DesignBench(dut, dut) {}
  DesignBench(const DutMaker<Design>& dut, const DutMaker<Design>& instrumented)
      : dut_(dut), instrumented_(instrumented) {}

  std::string design() const override { return Design::name; }
  std::string source() const override { return source_of<Design>(); }
  std::vector<Parameter> parameters() const override {
    const auto list = parameters_of<Design>(dut_.params);
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
  std::vector<std::string> assumed() const override {
    std::vector<std::string> all;
    const auto rules =
        legal_of<Word>(dut_.params, reset_state_of<Design, Word>(), rest_of<Design>());
    for (const Stated<Word>& rule : rules) all.emplace_back(rule.sentence);
    return all;
  }
  std::vector<Probe> probes() const override {
    const auto list = ViewOf<Design>::probes(dut_.params);
    return {list.begin(), list.end()};
  }
  std::size_t registers() const override {
    return fields<typename Design::template Registers<Word>>().size();
  }
  std::vector<Word> rest() const override { return words(rest_of<Design>()); }
  std::vector<Word> idle_after(const std::vector<Word>& state,
                               const std::vector<Word>& inputs) const override {
    using State = typename Design::template State<Word>;
    using Inputs = typename Design::template Inputs<Word>;
    const auto after = clocked<Design, Word>(dut_.params, Cells<State>(dut_.params).record(state),
                                             Cells<Inputs>(dut_.params).record(inputs));
    return words(idle_of<Design, Word>(dut_.params, after.state));
  }
  std::vector<Word> reset_state() const override { return words(reset_state_of<Design, Word>()); }
  std::vector<Word> begun(std::uint32_t power_up) const override {
    return words(AnyLockstep<Design>(start(power_up)).dut().registers());
  }
  typename Design::Params params() const override { return dut_.params; }
  std::unique_ptr<AnyLockstep<Design>> lockstep(std::uint32_t power_up) const override {
    return std::make_unique<AnyLockstep<Design>>(start(power_up));
  }
  std::unique_ptr<Dut<Design>> dut(std::uint32_t power_up) const override {
    return dut_.make(power_up);
  }

  std::string hostile_text() const override {
    return assumed().empty() ? AnyBench::hostile_text()
                             : "any value that its rules allow on any pin on any clock";
  }
  Run run_hostile(const HostileCase& c) const override {
    const HostileStimulus<Design> hostile(params(), c);
    draw_if_wanted(*this,
                   [&] { return recorded<Design>(params(), hostile, c.power_up(), c.clocks); });
    Run result;
    HostileStimulus<Design> left = hostile;
    const auto both = loop(c.power_up());
    const bool same = both->through(left, result.clocks);
    result.left_out = both->left_out();
    if (!same) {
      result.mismatch = examined(hostile, result.clocks - 1, c.power_up());
    }
    return result;
  }
  Stimulus hostile(const HostileCase& c) const override {
    return titled(
        recorded<Design>(params(), HostileStimulus<Design>(params(), c), c.power_up(), c.clocks));
  }
  std::unique_ptr<Session<Design>> open(std::uint32_t power_up) const override {
    return std::make_unique<HostSession>(*this, power_up);
  }
  ResetInputs reset_inputs() const override {
    if constexpr (has_reset<Design>)
      return {words(reset_inputs_of<Design>()), reset_clocks_of<Design>()};
    return {words(rest_of<Design>()), 0};
  }
  void watch_hostile(const HostileCase& c, const Watch& watch) const override {
    follow(HostileStimulus<Design>(params(), c), c.power_up(), watch);
  }
  void watch_stimulus(const Stimulus& s, const Watch& watch) const override {
    follow(Rows<Design>(params(), s), s.power_up, watch);
  }
  void watch_drawn(std::span<const Job> jobs, std::uint32_t power_up,
                   const Watch& watch) const override {
    follow(Host(params(), jobs), power_up, watch);
  }
  void watch_jobs(const JobList& jobs, std::uint32_t power_up, const Watch& watch) const override {
    watch_drawn(typed(jobs), power_up, watch);
  }

  std::vector<JobField> job_fields() const override {
    if constexpr (DeclaresJobs<Design>) {
      const auto list = Job::job_fields(dut_.params);
      return {list.begin(), list.end()};
    }
    return {};
  }
  std::string describe(const JobList& jobs) const override {
    std::string text;
    for (const Job& job : typed(jobs)) {
      text += (text.empty() ? "" : "; ") + Host::describe(params(), job);
    }
    return text;
  }
  JobsRun run_jobs(const JobList& jobs, std::uint32_t power_up) const override {
    JobsRun result;
    if constexpr (DeclaresJobs<Design>) {
      const std::vector<Job> all = typed(jobs);
      JobCheck<Design> check(params(), all);
      result.run = open(power_up)->draw(all, check);
      result.checked = check.so_far();
    }
    return result;
  }
  std::shared_ptr<const LaneJobs> lane_jobs(
      std::function<JobList(std::uint64_t i)> jobs) const override {
    if constexpr (DeclaresJobs<Design>) {
      constexpr std::uint64_t cases_a_lane = 128;
      return std::make_shared<LaneJobsOf<Design>>(
          params(),
          [jobs = std::move(jobs)](std::uint64_t i) { return one_by_one(typed(jobs(i))); },
          cases_a_lane);
    }
    return {};
  }
  Stimulus stimulus_of(const JobList& jobs, std::uint32_t power_up) const override {
    constexpr std::uint64_t most = ~std::uint64_t{0};
    const std::vector<Job> all = typed(jobs);
    return titled(recorded<Design>(params(), Host(params(), all), power_up, most));
  }

  Run replay(const Stimulus& s, Window window) const override {
    Run result = replayed(instrumented_, s, window);
    if (result.mismatch) result.mismatch->bench = this;
    return result;
  }
  std::optional<std::uint64_t> first_difference(const Stimulus& s) const override {
    // The class without the open hierarchy is faster, and a start from a reset needs no more.
    return ran(s.state ? instrumented_ : dut_, s).differs;
  }
  void show(const Stimulus& s, Window around, WaveSink& sink) const override {
    record_wave(instrumented_, s, around,
                {this->title(), inputs(), compared(), registers(), probes()}, sink);
  }

 protected:
  /// A new lockstep that has just been reset.
  virtual std::unique_ptr<Loop<Design>> loop(std::uint32_t power_up) const = 0;

  typename AnyAdapter<Design>::PowerUp start(std::uint32_t power_up) const {
    return {dut_, power_up};
  }

 private:
  class HostSession final : public Session<Design> {
   public:
    HostSession(const DesignBench& bench, std::uint32_t power_up)
        : bench_(bench), power_up_(power_up), loop_(bench.loop(power_up)) {}
    ~HostSession() override {
      draw_if_wanted(bench_, [this] { return stimulus(); });
    }

    Run draw(std::span<const Job> jobs, Observer<Design>& observer) override {
      history_.insert(history_.end(), jobs.begin(), jobs.end());
      Host host(bench_.params(), jobs);
      Run result;
      const auto before = loop_->left_out();
      const bool same = loop_->through(host, observer, result.clocks);
      result.left_out = loop_->left_out();
      for (std::size_t i = 0; i < before.size(); ++i) result.left_out[i] -= before[i];
      clocks_ += result.clocks;
      if (!same) {
        result.mismatch = bench_.examined(Host(bench_.params(), history_), clocks_ - 1, power_up_);
        result.mismatch->smaller_case = [maker = bench_.dut_, jobs = history_,
                                         power_up = power_up_] {
          return smaller_case<Design>(maker, jobs, power_up);
        };
      }
      return result;
    }

    Stimulus stimulus() const override {
      return recorded<Design>(bench_.params(), Host(bench_.params(), history_), power_up_, clocks_);
    }

   private:
    const DesignBench& bench_;
    std::uint32_t power_up_;
    std::unique_ptr<Loop<Design>> loop_;
    std::uint64_t clocks_ = 0;
    std::vector<Job> history_;  // to come to the same clock again
  };

  template <class Source>
  void follow(Source source, std::uint32_t power_up, const Watch& watch) const {
    const Cells<typename Design::template Registers<Word>> registers(dut_.params);
    const Cells<typename Design::template Outputs<Word>> outputs(dut_.params);
    AnyLockstep<Design> both(start(power_up));
    typename Design::template Inputs<Word> in;
    Watched seen;
    while (next_inputs<Design>(source, dut_.params, both.state(), in, both.expected().outputs)) {
      if (!both.clock(in)) throw InputError(this->title() + ": RTL and model differ");
      seen.inputs = words(in);
      seen.expected = registers.words(both.expected().registers);
      const auto more = outputs.words(both.expected().outputs);
      seen.expected.insert(seen.expected.end(), more.begin(), more.end());
      seen.is_compared.resize(seen.expected.size());
      for (std::size_t i = 0; i < seen.expected.size(); ++i) {
        seen.is_compared[i] = both.mask().of_cell(i);
      }
      if (!watch(seen)) return;
    }
  }
  /// Describes the first difference, which is on `clock` of the inputs from `source`.
  template <class Source>
  Mismatch examined(const Source& source, std::uint64_t clock, std::uint32_t power_up) const {
    AnyLockstep<Design> again(start(power_up));
    Mismatch mismatch = examine(again, source, clock, Window{}, this->title());
    mismatch.bench = this;
    mismatch.stimulus.power_up = power_up;
    return mismatch;
  }
  static std::vector<Job> typed(const JobList& jobs) {
    std::vector<Job> all;
    if constexpr (DeclaresJobs<Design>) {
      for (const auto& values : jobs) {
        Job& job = all.emplace_back();
        for_each_member<Job>([&](auto member, std::size_t i) { job.*member = values[i]; });
      }
    }
    return all;
  }
  Stimulus titled(Stimulus stimulus) const {
    stimulus.machine = this->title();
    return stimulus;
  }
  template <class Record>
  std::vector<Field> fields() const {
    return Cells<Record>(dut_.params).fields();
  }
  template <class Record>
  std::vector<Word> words(const Record& record) const {
    return Cells<Record>(dut_.params).words(record);
  }

  DutMaker<Design> dut_, instrumented_;
};

/// For short runs: nothing is compiled for a shape.
template <class Design>
class ShortBench : public DesignBench<Design> {
 public:
  using DesignBench<Design>::DesignBench;

 protected:
  std::unique_ptr<Loop<Design>> loop(std::uint32_t power_up) const override {
    return std::make_unique<AdapterLoop<AnyAdapter<Design>>>(this->start(power_up));
  }
};

/// The bench of one adapter, for short runs.
template <class Adapter>
class AdapterBench final : public ShortBench<typename Adapter::Design> {
 public:
  AdapterBench() : ShortBench<typename Adapter::Design>(dut_maker<Adapter>()) {}
};

/// The same with loops compiled for this adapter, for long runs.
template <class Adapter>
class FastBench final : public DesignBench<typename Adapter::Design> {
  using Design = typename Adapter::Design;

 public:
  FastBench() : FastBench(dut_maker<Adapter>()) {}
  /// `instrumented` as DesignBench has it.
  explicit FastBench(const DutMaker<Design>& instrumented)
      : DesignBench<Design>(dut_maker<Adapter>(), instrumented) {}

 protected:
  std::unique_ptr<Loop<Design>> loop(std::uint32_t power_up) const override {
    return std::make_unique<AdapterLoop<Adapter>>(power_up);
  }
};

}  // namespace cosim
