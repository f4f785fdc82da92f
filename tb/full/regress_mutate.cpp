// Campaigns of mutants as tasks of a regression: a mutant is a unit.
#include <fmt/core.h>

#include <map>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/full/mutants_built.h"
#include "tb/full/regress_kinds.h"
#include "tb/util/json.h"
#include "tb/util/json_at.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

class MutateWork final : public regress::Work {
 public:
  MutateWork(std::string title, std::uint64_t mutants, std::string program, bool unproved)
      : Work(std::move(title), mutants), program_(std::move(program)), unproved_(unproved) {}

  Json run(std::uint64_t first, std::uint64_t last, const regress::Place& place) const override {
    // The campaign has a checkpoint of its own, beside its results.
    const fs::path results = place.run / "checkpoints" / fmt::format("{}.mutants", place.shard);
    std::vector<std::string> words =
        words_in(fmt::format("--first {} --count {} --jobs 1 --failures", first + 1, last - first));
    words.push_back(place.failures().string());
    words.insert(words.begin(), {results.string(), "--prover", program_name() + " prove"});
    if (unproved_) words.emplace_back("--unproved");
    const Ended ended = run_mutants((place.run / program_).string(), words);
    const JsonAt all(results.string(), read_file(results.string()));
    const JsonAt outcomes = all.at("outcomes");
    Json json{{"outcomes", outcomes.json()}};
    for (const JsonAt& one : outcomes.list(last - first, last - first)) {
      if (one.at("end").text() == "survived") {
        json["failed"].push_back(survivor(one, ended.text, place));
      }
    }
    fs::remove(results);
    return json;
  }

  Json merged(const std::vector<regress::Part>& parts) const override {
    Json outcomes = Json::array();
    std::map<std::string, std::uint64_t> ends{
        {"killed", 0}, {"equivalent", 0}, {"survived", 0}, {"unread", 0}};
    for (const regress::Part& part : parts) {
      for (const JsonAt& one : part.result.at("outcomes").list(part.units(), part.units())) {
        const JsonAt end = one.at("end");
        if (!ends.contains(end.text())) end.fail("is no end of a mutant");
        ++ends[end.text()];
        outcomes.push_back(one.json());
      }
    }
    return {{"mutants", outcomes.size()},       {"killed", ends["killed"]},
            {"equivalent", ends["equivalent"]}, {"survived", ends["survived"]},
            {"unread", ends["unread"]},         {"outcomes", outcomes}};
  }

 private:
  // The program says where it left the folder.
  static Json survivor(const JsonAt& mutant, const std::string& said, const regress::Place& place) {
    const std::string what = mutant.at("what").text();
    Json json{{"what", fmt::format("mutant {} survived: {}", mutant.at("mutant").whole(), what)}};
    const std::string begin = fmt::format("survived: {}, kept in: ", what);
    for (const std::string& line : lines_in(said)) {
      if (!line.starts_with(begin)) continue;
      json["folder"] = fs::path(line.substr(begin.size())).lexically_relative(place.run).string();
    }
    return json;
  }

  std::string program_;
  bool unproved_;
};

class MutateKind final : public regress::Kind {
 public:
  explicit MutateKind(const Registry& registry) : registry_(registry) {}

  regress::Keys keys() const override {
    using Type = regress::Key::Type;
    return {"mutate",
            {{"mutate", Type::text, "A design, or a line of 'list'; each mutant is to be found"},
             {"mutants", Type::number,
              "At most N for each configuration that is built; default 100", 1, 65535},
             {"programs", Type::words,
              "Instead of building any: programs that attack mutants, from the plan's folder"},
             {"unproved", Type::yes, "Prove none to be equal: what is not killed survives"}}};
  }

  void keep(regress::Task& task, const fs::path& plan, const fs::path& run) const override {
    Json programs = Json::array();
    for (const std::string& program : programs_of(task, plan)) {
      programs.push_back(kept_with("programs", program, plan, run));
    }
    task.values["programs"] = std::move(programs);
  }

  regress::Works works(const regress::Task& task, const fs::path& folder) const override {
    regress::Works works;
    for (const std::string& program : programs_of(task, folder)) {
      const Mutants all = mutants_of((folder / program).string());
      works.push_back(
          std::make_unique<MutateWork>(fmt::format("{}, {}", all.of, count(all.count, "mutant")),
                                       all.count, program, task.has("unproved")));
    }
    return works;
  }

 private:
  // Their paths, from the folder. Absolute ones of those that are built on demand.
  std::vector<std::string> programs_of(const regress::Task& task, const fs::path& folder) const {
    if (task.has("programs")) {
      auto programs = task.values.at("programs").get<std::vector<std::string>>();
      for (const std::string& one : programs) {
        if (!fs::is_regular_file(folder / one)) throw InputError("programs: no such file: " + one);
      }
      return programs;
    }
    std::vector<std::string> programs;
    for (const AnyBench* bench : chosen_shapes(words_in(task.text("mutate")))) {
      programs.push_back(built_mutants(registry_, *bench, task.number("mutants", 100)));
    }
    return programs;
  }

  const Registry& registry_;
};

}  // namespace

std::unique_ptr<regress::Kind> mutate_kind(const Registry& registry) {
  return std::make_unique<MutateKind>(registry);
}

}  // namespace cosim::cli
