// Sweeps as tasks of a regression.
#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/result_json.h"
#include "tb/cli/sweeps.h"
#include "tb/full/in_lanes.h"
#include "tb/full/regress_kinds.h"
#include "tb/sim/failure.h"
#include "tb/sim/report.h"
#include "tb/util/interrupt.h"
#include "tb/util/json.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t most_cases = std::uint64_t{1} << 48;

class SweepWork final : public regress::Work {
 public:
  /// `clocks`: of a sweep of hostile ones, which run in lanes where they are worth it; else 0.
  /// `lanes`: where they are asked for. `may_be_empty`: it may compare nothing.
  SweepWork(const AnyBench& bench, Sweep sweep, std::uint64_t seed, std::uint64_t clocks,
            bool lanes, bool may_be_empty)
      : Work(fmt::format("{}, {}", bench.title(), sweep.name), sweep.cases),
        bench_(bench),
        sweep_(std::move(sweep)),
        seed_(seed),
        clocks_(clocks),
        lanes_(lanes),
        may_be_empty_(may_be_empty) {}

  bool ends_at_failure() const override { return true; }
  void prepare(const std::filesystem::path& prepared, bool elsewhere) const override {
    if (elsewhere) bench_.prepare_replays();
    prepare_lanes(bench_, sweep_, clocks_, lanes_, elsewhere, prepared);
  }
  Json run(std::uint64_t first, std::uint64_t last, const regress::Place& place) const override;
  Json merged(const std::vector<regress::Part>& parts) const override;

 private:
  Json kept(const Result& result, const regress::Place& place) const;

  const AnyBench& bench_;
  Sweep sweep_;
  std::uint64_t seed_, clocks_;
  bool lanes_, may_be_empty_;
};

// A sweep that ends before case `last` and, as one that goes on, begins with case `first`: cases
// keep their numbers.
Json SweepWork::run(std::uint64_t first, std::uint64_t last, const regress::Place& place) const {
  const Sweep all = in_prepared_lanes(bench_, sweep_, seed_, clocks_, place.prepared);
  Sweep part = interruptible(all);
  part.cases = last;
  Resume resume;
  resume.done.cases = first;
  if (const auto state = place.checkpoint.state()) {
    state->at("cases").whole(first, last);
    resume.done = result_from(*state, bench_);
  }
  Result done = resume.done;
  resume.keep = [&](const Result& now) {
    done = now;
    if (place.checkpoint.due()) place.checkpoint.save(to_json(now));
  };
  Result result;
  try {
    result = run_sweep(part, 1, {}, resume);
  } catch (const Interrupted&) {
    place.checkpoint.save(to_json(done));
    throw;
  }
  result.cases -= first;
  Json json = to_json(result);
  if (!result.match()) {
    json["mismatch"] = json_of(run_json({&bench_, sweep_.name, result})).at("mismatch");
    json["failed"].push_back(kept(result, place));
  }
  return json;
}

// The failure for the report, and its folder.
Json SweepWork::kept(const Result& result, const regress::Place& place) const {
  if (!result.mismatch) {
    return {{"what", fmt::format("{}: RTL and model agree, but the checker reports: {}",
                                 result.failed, result.checked.error)}};
  }
  const Mismatch& m = *result.mismatch;
  const Failure failure = leave_failure(bench_, result.failed, m, {place.failures()});
  const std::string folder = failure.folder.lexically_relative(place.run).string();
  return {{"what", fmt::format("{}: clock {}, {}", result.failed, m.clock,
                               m.finding.empty() ? m.signal : m.finding)},
          {"folder", folder},
          {"command", "replay " + folder}};
}

Json SweepWork::merged(const std::vector<regress::Part>& parts) const {
  Result sum;
  std::optional<Json> mismatch;
  for (const regress::Part& part : parts) {
    part.result.at("cases").whole(part.failed ? 1 : part.units(), part.units());
    add(sum, result_from(part.result, bench_));
    if (const auto one = part.result.find("mismatch")) mismatch = one->json();
  }
  const Outcome outcome{&bench_, sweep_.name, sum};
  auto json = json_of(run_json(outcome));
  json["cases"] = sum.cases;
  if (!mismatch && !may_be_empty_ && compared_nothing(outcome)) {
    json["failed"].push_back({{"what", nothing_text(outcome, "\"allow_nothing_compared\"")}});
  }
  if (mismatch) {
    json["verdict"] = "mismatch";
    json["mismatch"] = *mismatch;
  }
  return json;
}

class SweepKind final : public regress::Kind {
 public:
  explicit SweepKind(const Registry& registry) : registry_(registry) {}

  regress::Keys keys() const override {
    using Type = regress::Key::Type;
    return {
        "sweep",
        {{"sweep", Type::text,
          "A design, or a line of 'list': NAME M=5 N=2; every built configuration"},
         {"exhaustive", Type::yes, "Everything, at the widths small enough for it"},
         {"random", Type::number, "So many random cases at each width", 1, most_cases},
         {"hostile", Type::number, "So many clocks of any value on any pin at each width", 1,
          most_cases},
         {"lanes", Type::yes, "Hundreds of cases at a time: jobs, too, and more can be exhausted"},
         {"allow_nothing_compared", Type::yes, "A sweep that compares nothing is no failure"}}};
  }
  regress::Works works(const regress::Task& task, const std::filesystem::path&) const override;

 private:
  const Registry& registry_;
};

regress::Works SweepKind::works(const regress::Task& task, const std::filesystem::path&) const {
  const auto benches = chosen_benches(words_in(task.text("sweep")));
  const auto& all = all_sweeps(registry_);
  const auto& design = **std::ranges::find_if(
      all, [&](const DesignSweeps* one) { return one->design == benches.front()->design(); });
  const bool lanes = task.has("lanes"), may_be_empty = task.has("allow_nothing_compared");
  if (task.values.size() != 2U + (lanes ? 1 : 0) + (may_be_empty ? 1 : 0)) {
    throw InputError("needs one of \"exhaustive\", \"random\" and \"hostile\"");
  }
  if ((task.has("exhaustive") && !design.exhaustive) || (task.has("random") && !design.random)) {
    throw InputError(fmt::format("{} has no {} sweep", design.design,
                                 task.has("random") ? "random" : "exhaustive"));
  }
  regress::Works works;
  const std::uint64_t clocks = task.has("hostile") ? task.number("hostile") : 0;
  const std::uint64_t cases = task.has("random") ? task.number("random") : 0;
  const Asked asked{task.has("exhaustive"), cases, clocks, task.seed, lanes};
  for (auto& [bench, sweep] : planned(design, benches, asked)) {
    works.push_back(std::make_unique<SweepWork>(*bench, std::move(sweep), task.seed, clocks, lanes,
                                                may_be_empty));
  }
  if (works.empty()) {
    const std::string narrow = design.exhaustible.substr(0, design.exhaustible.find(','));
    throw InputError(fmt::format("exhaustive: too wide to try everything; take {}{}", narrow,
                                 lanes ? "" : ", or more with \"lanes\""));
  }
  return works;
}

}  // namespace

std::unique_ptr<regress::Kind> sweep_kind(const Registry& registry) {
  return std::make_unique<SweepKind>(registry);
}

}  // namespace cosim::cli
