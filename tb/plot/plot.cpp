#include "tb/plot/plot.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "model/core/input_error.h"
#include "tb/finite.h"
#include "tb/plot/script.h"
#include "tb/proof/process.h"

namespace cosim {

namespace fs = std::filesystem;

void Series::add(const Mark& mark) {
  if (marks.size() == most_marks) {
    throw InputError(
        fmt::format("--plot: a path of more than {} steps is too long to draw", most_marks - 1));
  }
  finite(mark.off);
  finite(mark.along);
  marks.push_back(mark);
}

void check_plot(const std::string& path) {
  const fs::path file(path);
  if ((file.extension() != ".svg" && file.extension() != ".png") || file.stem().empty()) {
    throw InputError(fmt::format("--plot: {} does not end in .svg or .png", path));
  }
  if (proof::run_program({"gnuplot", "--version"}).status != 0) {
    throw InputError("--plot: needs gnuplot, which is not installed (apt-get install gnuplot-nox)");
  }
}

void draw_plot(const std::string& path, const Plot& plot) {
  const proof::Scratch scratch;
  const std::string script = scratch.path() / "plot.gp";
  {
    std::ofstream out(script);
    write_script(out, path, plot);
    if (!out.flush()) throw InputError(fmt::format("--plot: {}: cannot write", script));
  }
  const auto ended = proof::run_program({"gnuplot", script});
  if (ended.status != 0) throw InputError(fmt::format("--plot: {}: gnuplot failed", path));
}

}  // namespace cosim
