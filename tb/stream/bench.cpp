#include "tb/stream/bench.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/core/input_error.h"
#include "tb/sim/wanted.h"
#include "tb/stream/record.h"
#include "tb/stream/runner.h"
#include "tb/util/words.h"

namespace cosim {

namespace {

constexpr std::uint64_t no_budget = ~std::uint64_t{0};

std::string outcome_text(const StreamShape& shape, const StreamResult& r) {
  if (r.finding) {
    return fmt::format("{} fails on clock {}", signal_of(shape, *r.finding), r.finding->clock);
  }
  std::uint64_t compared = 0;
  for (const Transactions& one : r.streams) compared += one.compared;
  return count(compared, "transaction") + " match";
}

}  // namespace

/// A case, what must come of it, and an instance to run it on: all kept from case to case.
struct AnyStreamBench::Rig {
  /// `other`: to be run on in place of instances of the bench; it can restart.
  explicit Rig(const AnyStreamBench& b, StreamDut* other = nullptr) : bench(b), given(b.shape_) {
    if (other != nullptr) runner.emplace(b.shape_, *(dut = other));
  }

  void load(const Stimulus& s) {
    given.clear();
    for (const std::vector<Word>& row : s.clocks) given.add(bench.shape_, row);
    power_up = s.power_up;
    broken = first_broken();
    if (broken == nullptr) bench.expect(given.given, expected);
  }
  /// Case number `number` of those that share the clocks of a hostile one.
  void draw(const HostileCase& c, std::uint64_t number) {
    power_up = draw_stream_case(bench.shape_, c.seed, c.index * c.clocks + number, c.clocks,
                                bench.may_go(), given);
    broken = nullptr;
    bench.expect(given.given, expected);
  }
  /// InputError where it breaks a rule.
  void refuse() const {
    if (broken == nullptr) return;
    throw InputError(
        fmt::format("{}: a transaction that breaks an assumption: {}", bench.title(), broken));
  }
  StreamResult run(std::uint64_t budget) {
    if (dut == nullptr || !dut->restart(power_up, bench.shape_.has_reset())) make();
    return runner->run(order(budget, false));
  }
  /// Runs a hostile case up to the first finding. Gives that, the number of its case, the clocks of
  /// those before it, and the transactions of all.
  struct Hostile {
    StreamResult last;
    std::uint64_t number = 0, clocks = 0;
    std::vector<Transactions> streams{};
    std::vector<std::uint64_t> happened{};
  };
  Hostile run(const HostileCase& c) {
    // Every case has a clock at least.
    Hostile all;
    all.happened.resize(bench.cases().size());
    for (;; ++all.number) {
      draw(c, all.number);
      all.last = run(c.clocks - all.clocks);
      add(all.streams, all.last.streams);
      count_cases(all.last.streams, all.happened);
      if (all.last.finding) return all;
      all.clocks += all.last.clocks;
      if (all.clocks >= c.clocks) return all;
    }
  }
  /// What happened to the transactions that went in, and to those that were compared.
  void count_cases(const std::vector<Transactions>& moved,
                   std::span<std::uint64_t> happened) const {
    if (happened.empty()) return;
    const StreamShape& shape = bench.shape_;
    for (std::size_t s = 0; s < moved.size(); ++s) {
      const bool goes_in = s < shape.in.size();
      const std::size_t number = goes_in ? s : s - shape.in.size();
      const std::size_t cases = (goes_in ? shape.in : shape.out)[number].cases.size();
      if (cases == 0) continue;
      bench.count_cases(goes_in, number, (goes_in ? given.given : expected)[number],
                        goes_in ? moved[s].moved : moved[s].compared, happened.first(cases));
      happened = happened.subspan(cases);
    }
  }
  /// On a new instance.
  StreamResult run_anew(bool gather, StreamObserver* observer = nullptr) {
    make();
    return runner->run(order(no_budget, gather, observer));
  }
  StreamOrder order(std::uint64_t budget, bool gather, StreamObserver* observer = nullptr) const {
    return {given, expected, bench.sizes(given.given), power_up, budget, gather, observer};
  }

  const AnyStreamBench& bench;
  std::uint32_t power_up = 1;
  StreamCase given;
  const char* broken = nullptr;  // the first rule that the case breaks; then it cannot be run
  std::vector<Sequence> expected;

 private:
  void make() {
    runner.reset();
    // First: with it goes the context that Verilator then takes for this thread's.
    machine.reset();
    machine = bench.dut(power_up);
    runner.emplace(bench.shape_, *(dut = machine.get()));
  }
  const char* first_broken() const {
    for (std::size_t s = 0; s < given.given.size() && !bench.assumed().empty(); ++s) {
      const Sequence& all = given.given[s];
      for (std::size_t n = 0; n < all.size(); ++n) {
        if (const char* rule = bench.broken_rule(s, all[n])) return rule;
      }
    }
    return nullptr;
  }

  std::unique_ptr<StreamDut> machine;
  StreamDut* dut = nullptr;
  std::optional<StreamRunner> runner;
};

/// A rig for as long as this lives; then another thread may have it.
class AnyStreamBench::Borrowed {
 public:
  explicit Borrowed(const AnyStreamBench& bench) : bench_(bench) {
    const std::lock_guard lock(bench.guard_);
    if (bench.spare_.empty()) {
      rig_ = std::make_unique<Rig>(bench);
    } else {
      rig_ = std::move(bench.spare_.back());
      bench.spare_.pop_back();
    }
  }
  ~Borrowed() {
    const std::lock_guard lock(bench_.guard_);
    bench_.spare_.push_back(std::move(rig_));
  }
  Borrowed(const Borrowed&) = delete;
  Borrowed& operator=(const Borrowed&) = delete;
  Rig* operator->() { return rig_.get(); }

 private:
  const AnyStreamBench& bench_;
  std::unique_ptr<Rig> rig_;
};

AnyStreamBench::AnyStreamBench() = default;
AnyStreamBench::~AnyStreamBench() = default;

void AnyStreamBench::fill_tables() {
  BenchTables& t = tables_;
  t.compared_text = "values and order of all that comes out at ";
  for (const Interface& i : shape_.in) t.streams.push_back({i.name, true});
  for (const Interface& i : shape_.out) {
    t.streams.push_back({i.name, false});
    t.compared.insert(t.compared.end(), i.cells.begin(), i.cells.end());
    t.compared_text += (&i == &shape_.out.front() ? "" : ", ") + i.name;
  }
  for (const auto* side : {&shape_.in, &shape_.out}) {
    for (const Interface& i : *side) {
      for (const std::string& one : i.cases) t.cases.push_back(i.name + ": " + one);
    }
  }
  t.inputs = shape_.columns();
  t.row = "transaction";
  t.rest.assign(t.inputs.size(), 0);
  t.hostile_text = "random transactions with random stalls";
  t.hostile_rows = "clocks of transactions";
}

MayGo AnyStreamBench::may_go() const {
  if (assumed().empty()) return {};
  return [this](std::size_t s, std::span<const Word> words) { return !broken_rule(s, words); };
}

Stimulus AnyStreamBench::drawn(const HostileCase& c, std::uint64_t number) const {
  return draw_stream_case(shape_, c.seed, c.index * c.clocks + number, c.clocks, may_go());
}

Stimulus AnyStreamBench::program(const std::string& path, std::uint64_t seed,
                                 std::string& wrong) const {
  std::vector<Sequence> given;
  wrong = read_program(path, given);
  return stalled(shape_, seed, given);
}

Run AnyStreamBench::run_hostile(const HostileCase& c) const {
  draw_if_wanted(*this, [&] { return drawn(c, 0); });
  const Rig::Hostile all = Borrowed(*this)->run(c);
  Run run;
  if (all.last.finding) {
    run = replay(drawn(c, all.number), Window{});
    const bool same = run.mismatch && run.mismatch->clock == all.last.finding->clock &&
                      run.mismatch->signal == signal_of(shape_, *all.last.finding);
    if (!same) refuse_unsteady(title());
  }
  run.clocks += all.clocks;
  run.streams = all.streams;
  run.happened = all.happened;
  return run;
}

std::optional<StreamFinding> AnyStreamBench::finding_on(StreamDut& other,
                                                        const HostileCase& c) const {
  return Rig(*this, &other).run(c).last.finding;
}

Run AnyStreamBench::replay(const Stimulus& stimulus, Window window) const {
  Rig rig(*this);
  rig.load(stimulus);
  rig.refuse();
  const StreamResult first = rig.run_anew(true);
  Run run;
  run.clocks = first.clocks;
  run.streams = first.streams;
  run.happened.resize(cases().size());
  rig.count_cases(first.streams, run.happened);
  if (!first.finding) return run;
  run.clocks = first.finding->clock + 1;
  TraceRecorder recorder(shape_, *first.finding, window);
  if (rig.run_anew(false, &recorder).finding != first.finding) refuse_unsteady(title());
  Mismatch m = recorder.take();
  m.bench = this;
  m.finding = to_text(shape_, rig.order(no_budget, true), first);
  m.told = told(*first.finding, rig.order(no_budget, true), first.came, recorder.taken());
  m.stimulus = stimulus;
  run.mismatch = std::move(m);
  return run;
}

std::optional<std::uint64_t> AnyStreamBench::first_difference(const Stimulus& stimulus) const {
  Borrowed rig(*this);
  rig->load(stimulus);
  if (rig->broken != nullptr || !rig->run(no_budget).finding) return {};
  // A row may matter as long as it is there, by the stall of what comes out last.
  return stimulus.clocks.size() - 1;
}

std::vector<std::vector<std::vector<Word>>> AnyStreamBench::without(
    const std::vector<std::vector<Word>>& rows, std::size_t n) const {
  if (n + 1 == rows.size()) return {};
  const auto later = [&](std::vector<std::vector<Word>>& changed, std::size_t column) {
    Word& stall = changed[n + 1][column];
    stall = std::min<Word>(stall + rows[n][column] + 1, (1 << stall_width) - 1);
  };
  // The next one goes in as late as it did, and what comes of it is taken as late, or at once.
  std::vector<std::vector<Word>> in = rows;
  std::size_t at = 0;
  for (const Interface& i : shape_.in) {
    later(in, at + 1);
    at += 2 + i.cells.size();
  }
  std::vector<std::vector<Word>> both = in;
  for (const Interface& i : shape_.out) {
    if (i.can_stall()) later(both, at++);
    if (!i.can_wait()) continue;
    both[n + 1][at] |= rows[n][at];
    ++at;
  }
  for (auto* changed : {&in, &both})
    changed->erase(changed->begin() + static_cast<std::ptrdiff_t>(n));
  return {in, both};
}

void AnyStreamBench::show(const Stimulus& stimulus, Window around, WaveSink& sink) const {
  Rig rig(*this);
  rig.load(stimulus);
  rig.refuse();
  const StreamResult first = rig.run_anew(false);
  const auto machine = open_dut(stimulus.power_up);
  WaveRecorder recorder(shape_, title(), *machine, first, around, sink);
  const StreamResult shown =
      StreamRunner(shape_, *machine).run(rig.order(no_budget, false, &recorder));
  recorder.end();
  if (shown.finding == first.finding && (first.finding || shown.streams == first.streams)) return;
  complain(
      fmt::format("{}: the wave is of another run than the verdict: in the wave {}, in the run "
                  "that was judged {}: does a driver, the model or the RTL depend on something "
                  "outside the case?",
                  title(), outcome_text(shape_, shown), outcome_text(shape_, first)));
}

}  // namespace cosim
