#include "tb/failure.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <nlohmann/json.hpp>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/output_file.h"
#include "tb/report.h"
#include "tb/shrink.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  OutputFile file(path.string());
  file.text(text);
  file.close();
}

// Under a name that no reader takes for a failure, until it is whole.
class Draft {
 public:
  Draft(const fs::path& root, const std::string& name)
      : target_(root / name),
        folder_(root / fmt::format(".{}.{}.{}", name, getpid(), drafts++)),
        old_(folder_.string() + ".old") {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) fail(error);
  }
  ~Draft() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    fs::remove_all(old_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const fs::path& folder() const { return folder_; }
  const fs::path& target() const { return target_; }

  // Another program may leave the same failure meanwhile: the last one stays.
  void finish() {
    std::error_code error;
    fs::rename(folder_, target_, error);
    for (int i = 0; i < 100 && in_the_way(error); ++i) {
      fs::remove_all(old_, error);
      fs::rename(target_, old_, error);
      fs::rename(folder_, target_, error);
    }
    if (error) fail(error);
  }

 private:
  static bool in_the_way(const std::error_code& error) {
    return error == std::errc::directory_not_empty || error == std::errc::file_exists ||
           error == std::errc::not_a_directory;
  }
  [[noreturn]] void fail(const std::error_code& error) const {
    throw InputError(fmt::format("{}: cannot write: {}", target_.string(), error.message()));
  }

  fs::path target_;
  fs::path folder_;
  fs::path old_;
  static inline std::atomic<unsigned> drafts = 0;
};

std::string clocks_text(std::size_t clocks) {
  return fmt::format("{} clock{}", clocks, clocks == 1 ? "" : "s");
}

}  // namespace

std::string failure_name(const AnyBench& bench, const std::string& what) {
  constexpr std::size_t longest = 60;
  std::string name;
  for (const char c : bench.title() + "-" + what) {
    if (c == '=') continue;
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.';
    if (plain) name += c;
    if (!plain && !name.empty() && name.back() != '-') name += '-';
  }
  name.resize(std::min(name.size(), longest));
  while (!name.empty() && !std::isalnum(static_cast<unsigned char>(name.back()))) name.pop_back();
  return name;
}

Failure leave_failure(const AnyBench& bench, const std::string& what, const Mismatch& mismatch,
                      const FailureOptions& options) {
  Draft draft(options.root, failure_name(bench, what));
  Failure failure;
  failure.folder = draft.target();
  failure.replay = fmt::format("{} replay {}", options.command, draft.target().string());

  Stimulus stimulus = mismatch.stimulus;
  stimulus.machine = bench.title();
  stimulus.origin = what;
  write(draft.folder() / "stimulus.stim", to_text(stimulus, bench));
  bench.draw_wave((draft.folder() / "wave.fst").string(), stimulus, options.wave);

  SmallerCase smallest{"", stimulus};
  if (mismatch.smaller_case) smallest = mismatch.smaller_case();
  smallest.stimulus.machine = bench.title();
  smallest.stimulus = shrink(bench, smallest.stimulus);
  smallest.stimulus.origin = "the smallest found of: " + what;
  write(draft.folder() / "smallest.stim", to_text(smallest.stimulus, bench));
  bench.draw_wave((draft.folder() / "smallest.fst").string(), smallest.stimulus, options.wave);
  const Run again = bench.replay(smallest.stimulus);

  if (!smallest.what.empty()) {
    failure.smallest = fmt::format("smallest case that still fails: {}\n", smallest.what);
  }
  failure.smallest += fmt::format("smallest stimulus that still fails: {}, smallest.stim\n",
                                  clocks_text(smallest.stimulus.clocks.size()));

  Outcome outcome{&bench, what, {}};
  outcome.result.cases = 1;
  outcome.result.clocks = mismatch.clock + 1;
  outcome.result.mismatch = mismatch;
  outcome.result.failed = what;
  write(draft.folder() / "report.txt",
        fmt::format("{}\n{}{}\nreplay: {}\n", verdict_text({outcome}), failure.smallest,
                    again.mismatch ? to_text(*again.mismatch) : "", failure.replay));
  nlohmann::ordered_json more;
  more["replay"] = failure.replay;
  more["smallest_case"] = smallest.what;
  more["smallest_clocks"] = smallest.stimulus.clocks.size();
  write_report((draft.folder() / "report.json").string(),
               report_json({outcome}, stimulus.power_up, more.dump()));
  draft.finish();
  return failure;
}

std::string to_text(const Failure& failure) {
  return fmt::format("{}kept in: {}\nreplay: {}\n", failure.smallest, failure.folder.string(),
                     failure.replay);
}

}  // namespace cosim
