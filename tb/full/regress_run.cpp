// Other programs as tasks of a regression: fuzzing by time, and any program that ends with 0.
#include <fmt/format.h>

#include "model/core/input_error.h"
#include "tb/full/regress_kinds.h"
#include "tb/util/json.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

std::string last_line(const std::string& text) {
  const std::string lines = text.substr(0, text.find_last_not_of('\n') + 1);
  return one_line(lines.substr(lines.find_last_of('\n') + 1));
}

// Of what libFuzzer says, the line that sums it up; it says more behind that.
std::string finding(const std::string& text) {
  const std::size_t at = text.find("SUMMARY: ");
  return at == std::string::npos ? last_line(text)
                                 : one_line(text.substr(at, text.find('\n', at) - at));
}

// Status 127 is of a program that is not there.
Ended run_it(const std::vector<std::string>& words) {
  Ended ended = cosim::run_program(words);
  if (ended.status == 127) throw InputError("needs " + words.front());
  return ended;
}

// A unit is a slice of so many seconds, with a seed of its own.
constexpr std::uint64_t slice = 60;

class FuzzWork final : public regress::Work {
 public:
  FuzzWork(const std::string& name, std::string target, std::string corpus, std::uint64_t seconds,
           std::uint64_t seed)
      : Work(fmt::format("{}, {} s", name, seconds), (seconds + slice - 1) / slice),
        target_(std::move(target)),
        corpus_(std::move(corpus)),
        seconds_(seconds),
        seed_(seed) {}

  Json run(std::uint64_t first, std::uint64_t last, const regress::Place& place) const override {
    Json failed = Json::array();
    for (std::uint64_t i = first; i < last; ++i) {
      const Scratch found;  // what it finds worth keeping is not kept
      // libFuzzer takes 31 bits, and 0 for a seed of its own.
      const std::uint64_t seed = (seed_ + i) % 0x7fffffff + 1;
      const fs::path artifact = place.failures() / fmt::format("fuzz-{}-{}-", place.shard, i);
      std::vector<std::string> words{
          (place.run / target_).string(),
          fmt::format("-max_total_time={}", std::min(slice, seconds_ - i * slice)),
          "-max_len=65536",
          "-timeout=1",
          "-rss_limit_mb=2048",
          fmt::format("-seed={}", seed),
          "-artifact_prefix=" + artifact.string(),
          found.path().string()};
      if (!corpus_.empty()) words.push_back((place.run / corpus_).string());
      const Ended ended = run_it(words);
      if (ended.status == 0) continue;
      failed.push_back(
          {{"what", fmt::format("slice {}: {}", i, finding(ended.text))}, {"folder", "failures"}});
    }
    Json json = Json::object();
    if (!failed.empty()) json["failed"] = std::move(failed);
    return json;
  }

  Json merged(const std::vector<regress::Part>&) const override { return {{"seconds", seconds_}}; }

 private:
  std::string target_, corpus_;
  std::uint64_t seconds_, seed_;
};

class FuzzKind final : public regress::Kind {
 public:
  regress::Keys keys() const override {
    using Type = regress::Key::Type;
    return {"fuzz",
            {{"fuzz", Type::text, "The program of a libFuzzer target, from the plan's folder"},
             {"corpus", Type::text, "A folder of inputs to begin with"},
             {"seconds", Type::number, "In slices of 60, each from another seed; default 60", 1,
              10'000'000}}};
  }
  void keep(regress::Task& task, const fs::path& plan, const fs::path& run) const override {
    for (const char* key : {"fuzz", "corpus"}) {
      if (task.has(key)) task.values[key] = kept_with(key, task.text(key), plan, run);
    }
  }
  regress::Works works(const regress::Task& task, const fs::path& folder) const override {
    for (const char* key : {"fuzz", "corpus"}) {
      if (task.has(key) && !fs::exists(folder / task.text(key))) {
        throw InputError(fmt::format("{}: no such file: {}", key, task.text(key)));
      }
    }
    regress::Works works;
    works.push_back(std::make_unique<FuzzWork>(fs::path(task.text("fuzz")).filename().string(),
                                               task.text("fuzz"), task.text("corpus"),
                                               task.number("seconds", slice), task.seed));
    return works;
  }
};

class RunWork final : public regress::Work {
 public:
  explicit RunWork(std::vector<std::string> words)
      : Work(one_line(fmt::format("{}", fmt::join(words, " "))), 1), words_(std::move(words)) {}

  Json run(std::uint64_t, std::uint64_t, const regress::Place&) const override {
    const Ended ended = run_it(words_);
    Json json{{"status", ended.status}};
    if (ended.status != 0) {
      json["failed"].push_back(
          {{"what", fmt::format("status {}: {}", ended.status, last_line(ended.text))}});
    }
    return json;
  }

  Json merged(const std::vector<regress::Part>& parts) const override {
    return {{"status", parts.front().result.at("status").whole(0, 255)}};
  }

 private:
  std::vector<std::string> words_;
};

class RunKind final : public regress::Kind {
 public:
  regress::Keys keys() const override {
    using Type = regress::Key::Type;
    return {"run",
            {{"run", Type::words, "A program and its arguments, on every host; is to end with 0"}}};
  }
  regress::Works works(const regress::Task& task, const fs::path&) const override {
    regress::Works works;
    works.push_back(
        std::make_unique<RunWork>(task.values.at("run").get<std::vector<std::string>>()));
    return works;
  }
};

}  // namespace

std::unique_ptr<regress::Kind> fuzz_kind() { return std::make_unique<FuzzKind>(); }
std::unique_ptr<regress::Kind> run_kind() { return std::make_unique<RunKind>(); }

}  // namespace cosim::cli
