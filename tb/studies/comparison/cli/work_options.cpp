#include "tb/studies/comparison/cli/work_options.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "model/toolpath/quantise.h"
#include "tb/program/number.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

using compare::Arc;
using compare::Line;

constexpr int widest_work = 16;
constexpr std::int64_t largest_major = (1 << widest_work) - 1;

Line parse_line(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw InputError(fmt::format("--line: {} is not BP,MP", in_quotes(text)));
  }
  const std::uint64_t major = whole("--line: BP", text.substr(0, comma), 1, largest_major);
  const std::uint64_t minor = whole("--line: MP", text.substr(comma + 1), 0, major);
  return {static_cast<std::int64_t>(major), static_cast<std::int64_t>(minor)};
}

NamedWork read_work(const std::string& file, const Text& steps_per_mm) {
  const double scale =
      positive("--steps-per-mm", needed("--steps-per-mm", steps_per_mm), toolpath::finest_grid);
  const toolpath::Plan plan = toolpath::plan(toolpath::read_gcode(read_file(file), file), scale);
  if (plan.pieces.empty()) {
    throw InputError(fmt::format("{}: no motion reaches a step at {} steps/mm", file, scale));
  }
  if (plan.longest_line > largest_major || plan.arc_width > widest_work) {
    throw InputError(fmt::format("{}: at {} steps/mm a line or a radius is above {}", file, scale,
                                 largest_major));
  }
  return {fmt::format("{} at {} steps/mm", one_line(file), scale), compare::work_of(plan)};
}

}  // namespace

void WorkOptions::add(const Command& command) {
  command.argument("FILE", file, "A G-code program: its lines, and its arcs");
  command.text("--steps-per-mm", steps_per_mm, "S", "Needed with FILE: steps of the grid to 1 mm");
  command.text("--line", line, "BP,MP", fmt::format("A line, BP at most {}", largest_major));
  command.text("--arc", arc, "R", fmt::format("A quarter circle, R at most {}", largest_major));
}

NamedWork parse_work(const WorkOptions& o) {
  const int kinds = (o.line ? 1 : 0) + (o.arc ? 1 : 0) + (o.file ? 1 : 0);
  if (kinds != 1) {
    throw InputError(fmt::format("compare: one of --line, --arc and FILE is needed, {}",
                                 kinds == 0 ? "none is given" : "more are given"));
  }
  if (o.file) return read_work(*o.file, o.steps_per_mm);
  if (o.steps_per_mm) throw InputError("--steps-per-mm: belongs to FILE");
  if (o.line) {
    const Line line = parse_line(*o.line);
    return {fmt::format("BP = {}, MP = {}", line.major, line.minor), compare::work_of(line)};
  }
  const auto radius = static_cast<std::int64_t>(whole("--arc", *o.arc, 1, largest_major));
  const Arc quarter{{radius, 0}, static_cast<std::uint64_t>(radius * radius), {0, radius}};
  return {fmt::format("R = {}, a quarter", radius), compare::work_of(quarter)};
}

}  // namespace cosim::cli
