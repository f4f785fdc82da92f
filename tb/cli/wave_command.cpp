// PROGRAM wave: a waveform, drawn and opened.
#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/commands.h"
#include "tb/cli/common.h"
#include "tb/cli/extent.h"
#include "tb/cli/number.h"
#include "tb/cli/outputs.h"
#include "tb/cli/wave.h"
#include "tb/show/view.h"
#include "tb/sim/stimulus_text.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

struct WaveOptions {
  Common common;
  std::vector<std::string> words;
  Text hostile, shot;
};

// What a comparison of two RTLs leaves has a wave and no stimulus of a design.
bool has_wave_alone(const fs::path& folder) {
  return fs::exists(folder / "wave.fst") && fs::exists(folder / "wave.gtkw") &&
         !fs::exists(folder / "stimulus.stim");
}

// The failure that was kept last. A folder that is not whole yet begins with a dot.
fs::path newest_failure(const fs::path& root) {
  std::optional<fs::directory_entry> newest;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(root, none)) {
    const bool is_one = fs::exists(entry.path() / "stimulus.stim") || has_wave_alone(entry.path());
    if (!is_one || entry.path().filename().string()[0] == '.') continue;
    if (!newest || entry.last_write_time() > newest->last_write_time()) newest = entry;
  }
  if (!newest)
    throw InputError(root.string() + ": no failure is kept there; name a stimulus or a design");
  return newest->path();
}

// What is to be drawn: a file, the folder of a failure, or hostile clocks of a design.
Replay read_replay(const WaveOptions& o) {
  const bool is_path = o.words.size() == 1 && fs::exists(o.words.front());
  if (!o.words.empty() && !is_path) {
    const bool is_file = o.words.front().find_first_of("./") != std::string::npos;
    if (is_file) throw InputError(o.words.front() + ": no such file");
    const AnyBench* bench = chosen_benches(o.words).front();
    const std::uint64_t clocks = whole("--hostile", o.hostile.value_or("300"), 1, most_wave_clocks);
    Replay drawn;
    drawn.bench = bench;
    drawn.stimulus = bench->hostile({o.common.seed(), 0, clocks});
    drawn.stimulus.origin = fmt::format("hostile clocks, seed {}", o.common.seed());
    return drawn;
  }
  if (o.hostile) throw InputError("--hostile: needs a design, not a file");
  fs::path path = o.words.front();
  if (fs::is_directory(path)) path /= "stimulus.stim";
  return read_stimulus(path.string(), benches());
}

void open_wave(const std::string& file) {
  const Ended ended = cosim::run_program({"gtkwave", file, view_file(file)});
  if (ended.status == 127) throw InputError("needs gtkwave; --out FILE.fst draws without it");
}

void check_shot(const std::string& file) {
  if (!file.ends_with(".png") || fs::path(file).stem() == ".png") {
    throw InputError(fmt::format("--shot: {} does not end in .png", file));
  }
  const fs::path folder = fs::absolute(file).parent_path();
  if (!fs::is_directory(folder)) throw InputError("--shot: there is no folder " + folder.string());
}

// Draws it; the wave, which is in `scratch` without --out.
std::string draw(WaveOptions& o, const Replay& drawn, const fs::path& scratch) {
  const bool is_kept = o.common.wave.has_value();
  if (!is_kept) o.common.wave = (scratch / "wave.fst").string();
  check_extent(o.common, {drawn.stimulus.clocks.size(), 0, 0, 0});
  check_outputs(o.common, {}, {drawn.bench});
  fmt::print("{}: {}\n", drawn.bench->title(), drawn.stimulus.origin);
  if (is_kept) {
    draw_wave(o.common, *drawn.bench, drawn.stimulus, drawn.stimulus.origin);
  } else {
    drawn.bench->draw_wave(*o.common.wave, drawn.stimulus, o.common.window());
  }
  return *o.common.wave;
}

int run(WaveOptions o) {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr && *value != '\0';
  };
  if (o.shot) check_shot(*o.shot);
  const bool opens = !o.common.wave && !o.shot;
  if (o.words.empty() && !o.hostile)
    o.words = {newest_failure(o.common.failures_folder()).string()};
  std::string wave = o.words.size() == 1 ? o.words.front() : "";
  if (has_wave_alone(wave)) wave = (fs::path(wave) / "wave.fst").string();
  const bool is_drawn = wave.ends_with(".fst") && fs::exists(wave);
  if (is_drawn && (o.common.wave || o.hostile)) throw InputError(wave + ": is drawn already");
  if (is_drawn && !fs::exists(view_file(wave))) {
    throw InputError(view_file(wave) + ": no such file; it is the view of " + wave);
  }
  std::optional<Replay> replay;
  if (!is_drawn) replay = read_replay(o);
  if (opens && !given("DISPLAY") && !given("WAYLAND_DISPLAY")) {
    throw InputError("there is no display; --shot FILE.png and --out FILE.fst draw without one");
  }
  const Scratch scratch;
  const std::string shown = is_drawn ? wave : draw(o, *replay, scratch.path());
  if (o.shot) {
    shoot(shown, *o.shot);
    fmt::print("picture: {}\n", *o.shot);
  }
  if (opens) open_wave(shown);
  return 0;
}

}  // namespace

void add_wave_command(const Command& program) {
  auto o = std::make_shared<WaveOptions>();
  const Command command = program.sub("wave", "A waveform of RTL and model, opened in GTKWave");
  command.arguments("WHAT", o->words,
                    "A stimulus, the folder of a failure, a wave, or a line of 'list', of which\n"
                    "hostile clocks are drawn; default the newest failure");
  command.text("--hostile", o->hostile, "CLOCKS", "How many hostile clocks are drawn; default 300");
  command.text("--out", o->common.wave, "FILE.fst",
               "Write the wave there, with FILE.gtkw, its view, and do not open it");
  command.text("--shot", o->shot, "FILE.png",
               "Write there what GTKWave shows, without a display (needs Xvfb)");
  command.text("--seed", o->common.seed_text, "S", "Seed of hostile clocks; default 1");
  command.text("--failures", o->common.failures, "DIR",
               "The folder of failures; default $COSIM_FAILURES or failures");
  add_window(command, o->common);
  const std::string what = benches().empty() ? "failures/TOP-equiv --shot it.png"
                                             : benches().front()->design() + " --out it.fst";
  command.footer(fmt::format("Example: {} wave {}", program_name(), what));
  command.action([o] { return run(*o); });
}

}  // namespace cosim::cli
