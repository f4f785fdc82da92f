// A wave as GTKWave shows it, without a display.
#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/show/view.h"
#include "tb/util/output_file.h"
#include "tb/util/process.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

// In a folder of its own: the wave and its view. The view names its files as they lie beside it.
constexpr const char* kRender = R"sh(
unset WAYLAND_DISPLAY
cd "$1" && mkfifo display || exit
Xvfb -displayfd 3 -noreset -nolisten tcp -screen 0 1600x1100x24 3> display &
read -r number < display && cd "$(dirname "$2")" || exit
export XDG_CACHE_HOME=$1  # GTK's settings
DISPLAY=:$number exec gtkwave --rcvar 'hide_sst on' -S "$1/shot.tcl" "$(basename "$2")" "$(basename "$3")"
)sh";

// On a busy computer the window is not whole at once: it is when three pictures of it are the same.
// GTK may lose the lengths of the scroll bars for good, so the window is drawn anew before each of
// them, by a command that changes nothing: no signal of a view is highlighted.
constexpr const char* kGrab = R"(
set before {{}}
for {{set alike 0}} {{$alike < 3}} {{incr alike}} {{
  after 100
  gtkwave::/Edit/UnHighlight_All
  gtkwave::/File/Grab_To_File {{{0}}}
  set file [open {{{0}}} rb]
  set now [read $file]
  close $file
  if {{$now ne $before}} {{set alike 0}}
  set before $now
}}
gtkwave::/File/Quit
)";

}  // namespace

void shoot(const std::string& fst, const std::string& png) {
  for (const char* program : {"gtkwave", "Xvfb"}) {
    if (!is_installed(program)) throw InputError(fmt::format("--shot: needs {}", program));
  }
  const Scratch scratch;
  const std::string folder = scratch.path(), picture = folder + "/shot.png";
  write_file(folder + "/shot.tcl", fmt::format(kGrab, picture));
  const Ended ended = run_until({"sh", "-c", kRender, "sh", folder, fs::absolute(fst).string(),
                                 fs::absolute(view_file(fst)).string()},
                                std::chrono::steady_clock::now() + std::chrono::seconds(120));
  if (!fs::exists(picture)) {
    const std::string said = ended.text.substr(0, ended.text.find('\n'));
    throw InputError("--shot: GTKWave renders nothing" + (said.empty() ? said : ": " + said));
  }
  std::error_code error;
  fs::copy_file(picture, png, fs::copy_options::overwrite_existing, error);
  if (error) throw InputError(png + ": cannot write: " + error.message());
}

}  // namespace cosim
