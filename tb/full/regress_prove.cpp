// Proofs as tasks of a regression: a claim on a machine is a unit.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/full/machine_of.h"
#include "tb/full/refuted.h"
#include "tb/full/regress_kinds.h"
#include "tb/full/trusted.h"
#include "tb/proof/decide.h"
#include "tb/sim/failure.h"
#include "tb/util/interrupt.h"
#include "tb/util/json.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t usual_limit = 300, longest_limit = 86400;

// Of a checkpoint.
Json decided_from(const JsonAt& json) {
  Json one{{"what", json.at("what").text()}, {"verdict", json.at("verdict").text()}};
  if (const auto failed = json.find("failed")) {
    one["failed"]["what"] = failed->at("what").text();
    for (const char* key : {"folder", "command"}) {
      if (const auto text = failed->find(key)) one["failed"][key] = text->text();
    }
  }
  return one;
}

// An engine that is not there is no finding of the proof.
void need_engines(const proof::Decision& decision) {
  for (const proof::Opinion& opinion : decision.opinions) {
    if (opinion.solved.answer == proof::Answer::missing) {
      throw InputError("needs " + to_text(opinion.engine));
    }
  }
}

class ProveWork final : public regress::Work {
 public:
  ProveWork(const proof::BuiltMachine& machine, std::uint64_t claims, int limit)
      : Work(machine.title, claims), machine_(machine), limit_(limit) {}

  Json run(std::uint64_t first, std::uint64_t last, const regress::Place& place) const override {
    const nets::Model model = machine_.nets();
    const proof::Source source = source_for(model, machine_.source);
    require_read(model, source);
    const auto claims = claims_of(model, source);
    if (claims.size() < units()) throw std::logic_error("other claims than were counted");
    // That RTL asserts something is not known before yosys reads it: the last unit has that claim
    // too.
    const std::uint64_t end = last == units() ? claims.size() : last;
    Json decided = Json::array();
    if (const auto state = place.checkpoint.state()) {
      for (const JsonAt& one : state->list(0, end - first)) decided.push_back(decided_from(one));
    }
    for (std::uint64_t i = first + decided.size(); i < end; ++i) {
      decided.push_back(decide_one(model, claims[i], place));
      place.checkpoint.save(decided);
    }
    Json all = Json::array(), failed = Json::array();
    for (const Json& one : decided) {
      all.push_back({{"what", one.at("what")}, {"verdict", one.at("verdict")}});
      if (one.contains("failed")) failed.push_back(one["failed"]);
    }
    Json json{{"claims", std::move(all)}};
    if (!failed.empty()) json["failed"] = std::move(failed);
    return json;
  }

  Json merged(const std::vector<regress::Part>& parts) const override {
    Json claims = Json::array();
    for (const regress::Part& part : parts) {
      const std::size_t more = part.last == units() ? 1 : 0;
      for (const JsonAt& one : part.result.at("claims").list(part.units(), part.units() + more)) {
        claims.push_back({{"what", one.at("what").text()}, {"verdict", one.at("verdict").text()}});
      }
    }
    return {{"claims", claims}};
  }

 private:
  Json decide_one(const nets::Model& model, const proof::Claim& claim,
                  const regress::Place& place) const {
    InterruptGuard::check();
    const proof::Decision decision =
        proof::decide({&claim}, {proof::all_engines(), limit_, 1}).front();
    need_engines(decision);
    Json json{{"what", claim.what}, {"verdict", decision.verdict}};
    if (decision.proved) return json;
    std::optional<FromResetAnswer> from_reset;
    if (claim.from_reset && !decision.disagree) {
      proof::Source source = source_for(model, machine_.source);
      source.keeps_statements = true;
      from_reset =
          asked_from_reset(proof::FromReset(model, proof::RtlNets(source)), *claim.from_reset,
                           bench_of(title()), std::chrono::seconds(limit_), 1);
      json["verdict"] = from_reset->verdict;
      if (from_reset->ever == proof::Ever::never) return json;
    }
    json["failed"] = failed(model, claim, decision, from_reset, place);
    return json;
  }

  // A counterexample that lockstep shows has a folder; else the command finds it again.
  Json failed(const nets::Model& model, const proof::Claim& claim, const proof::Decision& decision,
              const std::optional<FromResetAnswer>& from_reset, const regress::Place& place) const {
    Json json{{"what", fmt::format("{}: {}", claim.what,
                                   from_reset ? from_reset->verdict : decision.verdict)},
              {"command", "prove " + title()}};
    std::optional<Mismatch> mismatch;
    if (from_reset && from_reset->ever == proof::Ever::yes) {
      mismatch = from_reset->run.mismatch;
    } else if (auto found = refuted(model, bench_of(title()), decision)) {
      mismatch = std::move(found->run.mismatch);
    }
    if (!mismatch) return json;
    const Failure failure =
        leave_failure(bench_of(title()), fmt::format("{}: {}", refuted_case, claim.what), *mismatch,
                      {place.failures()});
    json["folder"] = failure.folder.lexically_relative(place.run).string();
    json["command"] = "replay " + json["folder"].get<std::string>();
    return json;
  }

  const proof::BuiltMachine& machine_;
  int limit_;
};

class ProveKind final : public regress::Kind {
 public:
  regress::Keys keys() const override {
    using Type = regress::Key::Type;
    return {"prove",
            {{"prove", Type::text, "A design, or a line of 'list'; RTL and model are the same"},
             {"limit", Type::number, "Seconds of processor time for one answer; default 300", 1,
              longest_limit}}};
  }

  regress::Works works(const regress::Task& task, const std::filesystem::path&) const override {
    const int limit = static_cast<int>(task.number("limit", usual_limit));
    regress::Works works;
    for (const AnyBench* bench : chosen_shapes(words_in(task.text("prove")))) {
      const proof::BuiltMachine& machine = machine_of(*bench);
      if (!machine.is_provable()) {
        throw InputError(fmt::format("{}: {}: nothing can be proved of it", machine.title,
                                     kind_of_model(machine)));
      }
      const auto model = machine.nets();
      const std::uint64_t claims =
          (model.machine.unobserved.empty() ? 3 : 2) + (model.machine.legal.empty() ? 0 : 1);
      works.push_back(std::make_unique<ProveWork>(machine, claims, limit));
    }
    return works;
  }
};

}  // namespace

std::unique_ptr<regress::Kind> prove_kind() { return std::make_unique<ProveKind>(); }

}  // namespace cosim::cli
