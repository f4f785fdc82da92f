// The bench of any shape. Hostile clocks and jobs run for long: where it pays their loop is
// compiled for each shape (loop.h). Everything else is compiled once for a design.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tb/sim/bench.h"
#include "tb/sim/job_check.h"
#include "tb/sim/lane_jobs.h"
#include "tb/sim/loop.h"
#include "tb/sim/recorder.h"
#include "tb/sim/replay.h"
#include "tb/sim/wanted.h"
#include "tb/util/words.h"

namespace cosim {

/// A bench whose RTL is what `dut` makes. `instrumented` makes the same with its whole hierarchy
/// open and with registers that can be loaded, for replays and waves; `loop` is for long runs.
template <class Design>
class DesignBench final : public Bench<Design> {
  using Host = HostOf<Design>;
  using Job = typename Host::Job;

 public:
  explicit DesignBench(const DutMaker<Design>& dut) : DesignBench(dut, dut) {}
  DesignBench(const DutMaker<Design>& dut, const DutMaker<Design>& instrumented,
              LoopMaker<Design> loop = short_loop<Design>)
      : dut_(dut), instrumented_(instrumented), make_loop_(std::move(loop)) {
    this->tables_ = tables();
  }

  Stimulus clock_from(const std::vector<Word>& state,
                      const std::vector<Word>& inputs) const override {
    using State = typename Design::template State<Word>;
    using Inputs = typename Design::template Inputs<Word>;
    const auto before = Cells<State>(dut_.params).record(state);
    const auto in = Cells<Inputs>(dut_.params).record(inputs);
    const auto after = clock_of<Design, Word>(dut_.params, before, in).state;
    const auto taken = Synchronizers<Design>(dut_.params).taken(dut_.params, before, in, after);
    Stimulus s;
    s.machine = this->title();
    s.state = state;
    s.clocks = {inputs, words(idle_of<Design, Word>(dut_.params, taken))};
    return s;
  }
  std::vector<Word> begun(std::uint32_t power_up) const override {
    return words(AnyLockstep<Design>(start(power_up)).dut().registers());
  }
  typename Design::Params params() const override { return dut_.params; }
  std::unique_ptr<AnyLockstep<Design>> lockstep(std::uint32_t power_up) const override {
    return std::make_unique<AnyLockstep<Design>>(start(power_up));
  }
  std::unique_ptr<AnyByHand> by_hand(std::uint32_t power_up) const override {
    return std::make_unique<HandLockstep>(start(power_up));
  }
  std::unique_ptr<Dut<Design>> dut(std::uint32_t power_up) const override {
    return dut_.make(power_up);
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
  void watch_hostile(const HostileCase& c, const Watch& watch) const override {
    follow(source_of<Design>(params(), HostileStimulus<Design>(params(), c)), c.power_up(), watch);
  }
  void watch_stimulus(const Stimulus& s, const Watch& watch) const override {
    follow(source_of<Design>(params(), Rows<Design>(params(), s)), s.power_up, watch);
  }
  void watch_drawn(std::span<const Job> jobs, std::uint32_t power_up,
                   const Watch& watch) const override {
    follow(source_of<Design>(params(), Host(params(), jobs)), power_up, watch);
  }
  void watch_jobs(const JobList& jobs, std::uint32_t power_up, const Watch& watch) const override {
    watch_drawn(typed(jobs), power_up, watch);
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

  void prepare_replays() const override { instrumented_.make(1); }
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
    record_wave(
        instrumented_, s, around,
        {this->title(), this->inputs(), this->compared(), this->registers(), this->probes()}, sink);
  }

 private:
  std::unique_ptr<Loop<Design>> loop(std::uint32_t power_up) const {
    return make_loop_(dut_, power_up);
  }
  typename AnyAdapter<Design>::PowerUp start(std::uint32_t power_up) const {
    return {dut_, power_up};
  }
  BenchTables tables() const {
    using State = typename Design::template State<Word>;
    const auto list = [](const auto& all) { return std::vector(all.begin(), all.end()); };
    BenchTables t;
    t.design = Design::name;
    t.source = Design::source;
    if constexpr (requires { Design::model(dut_.params); }) t.model = Design::model(dut_.params);
    t.parameters = list(Design::parameters(dut_.params));
    t.compared = fields<typename Design::template Registers<Word>>();
    t.registers = t.compared.size();
    const auto outputs = fields<typename Design::template Outputs<Word>>();
    t.compared.insert(t.compared.end(), outputs.begin(), outputs.end());
    t.compared_text = count(t.registers, "register") + " and " + count(outputs.size(), "output");
    t.inputs = fields<typename Design::template Inputs<Word>>();
    t.state = fields<State>();
    const State reset = reset_state_of<Design, Word>(dut_.params);
    t.reset_state = words(reset);
    t.rest = words(rest_of<Design>());
    t.reset_inputs = {t.rest, 0};
    if constexpr (has_reset<Design>) {
      t.reset_inputs = {words(reset_inputs_of<Design>()), reset_clocks_of<Design>()};
    }
    for (const auto& rule : legal_of<Word>(dut_.params, reset, rest_of<Design>())) {
      t.assumed.emplace_back(rule.sentence);
    }
    t.probes = list(ViewOf<Design>::probes(dut_.params));
    t.hostile_text = t.assumed.empty() ? "any value on any pin on any clock"
                                       : "any value that its rules allow on any pin on any clock";
    t.hostile_rows = "hostile clocks";
    if constexpr (DeclaresJobs<Design>) t.job_fields = list(Job::job_fields(dut_.params));
    return t;
  }

  class HandLockstep final : public AnyByHand {
   public:
    explicit HandLockstep(const typename AnyAdapter<Design>::PowerUp& start)
        : both_(start),
          inputs_(start.maker.params),
          outputs_(start.maker.params),
          state_(start.maker.params) {}
    const char* broken_rule(const std::vector<Word>& inputs) const override {
      return cosim::broken_rule<Design>(both_.dut().params, both_.state(), inputs_.record(inputs));
    }
    bool clock(const std::vector<Word>& inputs) override {
      return both_.clock(inputs_.record(inputs));
    }
    std::vector<Word> outputs() const override { return outputs_.words(both_.expected().outputs); }
    std::vector<Word> state() const override { return state_.words(both_.state()); }

   private:
    AnyLockstep<Design> both_;
    Cells<typename Design::template Inputs<Word>> inputs_;
    Cells<typename Design::template Outputs<Word>> outputs_;
    Cells<typename Design::template State<Word>> state_;
  };

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

  void follow(const InputSource<Design>& source, std::uint32_t power_up, const Watch& watch) const {
    const Cells<typename Design::template Registers<Word>> registers(dut_.params);
    const Cells<typename Design::template Outputs<Word>> outputs(dut_.params);
    AnyLockstep<Design> both(start(power_up));
    typename Design::template Inputs<Word> in;
    Watched seen;
    while (source(both.state(), in, both.expected().outputs)) {
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
    Mismatch mismatch =
        examine(again, source_of<Design>(params(), source), clock, Window{}, this->title());
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
  LoopMaker<Design> make_loop_;
};

}  // namespace cosim
