#include "tb/plot/plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "model/core/input_error.h"
#include "tb/plot/script.h"
#include "tb/support/finite.h"
#include "tb/support/output_file.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim {

namespace fs = std::filesystem;

void Series::check_steps(std::uint64_t steps) {
  if (steps < most_marks) return;
  throw InputError(
      fmt::format("--plot: a path of more than {} steps is too long to draw", most_marks - 1));
}

void Series::add(const Mark& mark) {
  check_steps(marks.size());
  finite(mark.off);
  finite(mark.along);
  marks.push_back(mark);
}

void check_plot() {
  if (run_program({"gnuplot", "--version"}).status != 0) {
    throw InputError("--plot: needs gnuplot, which is not installed (apt-get install gnuplot-nox)");
  }
}

void draw_plot(const std::string& path, const Plot& plot) {
  const Scratch scratch;
  const std::string script = scratch.path() / "plot.gp";
  const std::string picture = scratch.path() / ("picture" + fs::path(path).extension().string());
  {
    std::ofstream out(script);
    write_script(out, picture, plot);
    if (!out.flush()) throw InputError(fmt::format("--plot: {}: cannot write", script));
  }
  const auto ended = run_program({"gnuplot", script});
  if (ended.status != 0) throw InputError(fmt::format("--plot: {}: gnuplot failed", path));
  // Of a full disk gnuplot says nothing.
  const std::string text = read_file(picture);
  const std::string end = text.substr(text.size() - std::min<std::size_t>(text.size(), 12));
  if (end.find("</svg>") == std::string::npos && end.find("IEND") == std::string::npos) {
    throw InputError(fmt::format("--plot: {}: gnuplot could not write it whole", path));
  }
  write_file(path, text);  // it may be on another disk
}

}  // namespace cosim
