#include "tb/sweep/failure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "model/core/input_error.h"
#include "tb/sim/stimulus_text.h"
#include "tb/sweep/page.h"
#include "tb/sweep/report.h"
#include "tb/util/draft.h"
#include "tb/util/json.h"
#include "tb/util/output_file.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

// Of the folder: another one where a program that reads it has to know.
constexpr int format = 1;

std::string rows_text(const AnyBench& bench, std::size_t rows) {
  return fmt::format("{} {}{}", rows, bench.row(), rows == 1 ? "" : "s");
}

std::vector<Page::Command> commands_after(const Failure& failure) {
  const std::string folder = failure.folder.string();
  const std::string replay = fmt::format("{} replay {}/smallest.stim", program_name(), folder);
  return {{failure.replay, "The same run once more"},
          {replay, "The smallest stimulus"},
          {replay + " --html again.html", "A page of it like this one, after a change"},
          {fmt::format("{} wave {}", program_name(), folder), "The whole wave in GTKWave"},
          {fmt::format("cd {} && gtkwave wave.fst wave.gtkw", folder),
           "The same where there is only the folder"}};
}

using Clock = std::chrono::steady_clock;
using Rows = std::vector<std::vector<Word>>;

class Shrinker {
 public:
  Shrinker(const AnyBench& bench, Stimulus stimulus, std::chrono::milliseconds budget)
      : bench_(bench),
        rest_(bench.rest()),
        end_(Clock::now() + budget),
        best_(std::move(stimulus)) {}

  Stimulus run() {
    take(best_.clocks);
    for (bool again = true; again && in_time();) {
      again = fewer_clocks();
      again |= other_rows();
      again |= calmer_pins();
      again |= lower_values();
      again |= next_values();
    }
    return std::move(best_);
  }

 private:
  bool in_time() const { return Clock::now() < end_; }

  // Keeps the rows if they fail, up to the clock where they do.
  bool take(Rows rows) {
    if (rows.empty()) return false;
    Stimulus tried = best_;
    tried.clocks = std::move(rows);
    const auto clock = bench_.first_difference(tried);
    if (!clock) return false;
    tried.clocks.resize(*clock + 1);
    best_ = std::move(tried);
    return true;
  }

  // Delta debugging: without each of the pieces that the clocks are cut into, ever smaller ones,
  // from the end on.
  bool fewer_clocks() {
    bool any = false;
    for (std::size_t piece = best_.clocks.size() / 2; piece >= 1; piece /= 2) {
      for (std::size_t end = best_.clocks.size(); end > 0 && in_time();) {
        const std::size_t begin = end > piece ? end - piece : 0;
        Rows rows = best_.clocks;
        rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(begin),
                   rows.begin() + static_cast<std::ptrdiff_t>(std::min(end, rows.size())));
        any |= take(std::move(rows));
        end = std::min(begin, best_.clocks.size());
      }
    }
    return any;
  }

  // Without a row in a way that the bench knows, from the end on.
  bool other_rows() {
    bool any = false;
    for (std::size_t n = best_.clocks.size(); n-- > 0 && in_time();) {
      if (n >= best_.clocks.size()) continue;
      for (Rows& rows : bench_.without(best_.clocks, n)) {
        if (!take(std::move(rows))) continue;
        any = true;
        break;
      }
    }
    return any;
  }

  bool calmer_pins() {
    bool any = false;
    for (std::size_t pin = 0; pin < rest_.size() && in_time(); ++pin) {
      Rows rows = best_.clocks;
      for (auto& row : rows) row[pin] = rest_[pin];
      if (rows != best_.clocks) any |= take(std::move(rows));
    }
    for (std::size_t c = 0; c < best_.clocks.size() && in_time(); ++c) {
      if (best_.clocks[c] != rest_) any |= set(c, rest_);
      for (std::size_t pin = 0; pin < rest_.size() && c < best_.clocks.size(); ++pin) {
        if (best_.clocks[c][pin] == rest_[pin]) continue;
        std::vector<Word> row = best_.clocks[c];
        row[pin] = rest_[pin];
        any |= set(c, std::move(row));
      }
    }
    return any;
  }

  // Wide values, one bit less at a time, the highest first.
  bool lower_values() {
    bool any = false;
    for (std::size_t c = 0; c < best_.clocks.size() && in_time(); ++c) {
      for (std::size_t pin = 0; pin < rest_.size(); ++pin) {
        for (int i = 63; i >= 0 && c < best_.clocks.size() && in_time(); --i) {
          const Word value = best_.clocks[c][pin];
          if (value == rest_[pin] || (value >> i & 1) == 0) continue;
          std::vector<Word> row = best_.clocks[c];
          row[pin] = value ^ static_cast<Word>(std::uint64_t{1} << i);
          any |= set(c, std::move(row));
        }
      }
    }
    return any;
  }

  // The value after a wide one, which may be the address of another register, where that fails
  // sooner.
  bool next_values() {
    bool any = false;
    const std::vector<Field> pins = bench_.inputs();
    for (std::size_t c = 0; c < best_.clocks.size() && in_time(); ++c) {
      for (std::size_t pin = 0; pin < rest_.size() && c < best_.clocks.size(); ++pin) {
        if (pins[pin].width == 1) continue;
        const Stimulus before = best_;
        std::vector<Word> row = before.clocks[c];
        row[pin] = low_bits(add(row[pin], 1), pins[pin].width);
        if (!set(c, std::move(row))) continue;
        if (best_.clocks.size() < before.clocks.size()) {
          any = true;
        } else {
          best_ = before;
        }
      }
    }
    return any;
  }

  bool set(std::size_t clock, std::vector<Word> row) {
    Rows rows = best_.clocks;
    rows[clock] = std::move(row);
    return take(std::move(rows));
  }

  const AnyBench& bench_;
  std::vector<Word> rest_;
  Clock::time_point end_;
  Stimulus best_;
};

// The smallest stimulus found within `budget` on which RTL and model still differ: fewer clocks,
// pins at rest, lower values; it ends with the first clock that differs. `stimulus` fails on
// `bench`. It does not matter which signal differs first.
Stimulus shrink(const AnyBench& bench, Stimulus stimulus,
                std::chrono::milliseconds budget = std::chrono::seconds(8)) {
  return Shrinker(bench, std::move(stimulus), budget).run();
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
  failure.replay = fmt::format("{} replay {}", program_name(), draft.target().string());

  Stimulus stimulus = mismatch.stimulus;
  stimulus.machine = bench.title();
  stimulus.origin = what;
  draft.write("stimulus.stim", to_text(stimulus, bench));
  const WavePicture wave =
      bench.draw_wave((draft.folder() / "wave.fst").string(), stimulus, options.wave);

  SmallerCase smallest{"", stimulus};
  if (mismatch.smaller_case) smallest = mismatch.smaller_case();
  smallest.stimulus.machine = bench.title();
  smallest.stimulus = shrink(bench, smallest.stimulus);
  smallest.stimulus.origin = "the smallest found of: " + what;
  const std::string smallest_text = to_text(smallest.stimulus, bench);
  draft.write("smallest.stim", smallest_text);
  const WavePicture smallest_wave =
      bench.draw_wave((draft.folder() / "smallest.fst").string(), smallest.stimulus, options.wave);
  const Run again = bench.replay(smallest.stimulus);

  if (!smallest.what.empty()) {
    failure.smallest = fmt::format("smallest case that still fails: {}\n", smallest.what);
  }
  failure.smallest += fmt::format("smallest stimulus that still fails: {}, smallest.stim\n",
                                  rows_text(bench, smallest.stimulus.clocks.size()));

  Outcome outcome{&bench, what, {}};
  outcome.result.cases = 1;
  outcome.result.clocks = mismatch.clock + 1;
  outcome.result.mismatch = mismatch;
  outcome.result.failed = what;
  draft.write("report.txt",
              fmt::format("{}\n{}{}\nreplay: {}\n", verdict_text({outcome}), failure.smallest,
                          again.mismatch ? to_text(*again.mismatch) : "", failure.replay));
  failure.page = page_text(
      {{outcome},
       {{"The wave around the first difference",
         "wave.fst has more clocks, and the RTL's whole hierarchy.", wave},
        {"The smallest stimulus that still fails", failure.smallest, smallest_wave, smallest_text}},
       commands_after(failure)});
  draft.write("report.html", failure.page);
  Json more;
  more["format"] = format;
  more["replay"] = failure.replay;
  more["smallest_case"] = smallest.what;
  more[fmt::format("smallest_{}s", bench.row())] = smallest.stimulus.clocks.size();
  write_report((draft.folder() / "report.json").string(),
               report_json({outcome}, stimulus.power_up, json_text(more)));
  draft.finish_replacing();
  return failure;
}

std::string to_text(const Failure& failure) {
  return fmt::format("{}kept in: {}\nreplay: {}\n", failure.smallest, failure.folder.string(),
                     failure.replay);
}

}  // namespace cosim
