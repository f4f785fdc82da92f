#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

#include "model/circular/oracle.h"
#include "model/core/input_error.h"
#include "model/toolpath/plan.h"
#include "tb/cli/choose.h"
#include "tb/cli/command.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"
#include "tb/cli/outputs.h"
#include "tb/cli/words.h"
#include "tb/compare/contest.h"
#include "tb/plot/plot.h"

namespace cosim::cli {
namespace {

using compare::Algorithm;
using compare::Arc;
using compare::Entry;
using compare::Line;

constexpr std::uint64_t largest = 65535;
constexpr double finest_grid = 1e9;

struct Options {
  Common common;
  Text file, steps_per_mm, line, arc, algorithms;
};

struct Work {
  std::string text;
  std::vector<Line> lines;
  std::vector<Arc> arcs;
};

Line parse_line(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw InputError(fmt::format("--line: {} is not BP,MP", quoted(text)));
  }
  const std::uint64_t major = whole("--line: BP", text.substr(0, comma), 1, largest);
  const std::uint64_t minor = whole("--line: MP", text.substr(comma + 1), 0, major);
  return {static_cast<std::int64_t>(major), static_cast<std::int64_t>(minor)};
}

// The arc of a toolpath's piece, to where the circular machine is stopped.
Arc arc_of(const circular::Arc& job) {
  if (!job.count) return {job.from, job.radius2, circular::end_point(job.radius2)};
  circular::Point at = job.from;
  for (std::int64_t i = 0; i < *job.count; ++i) at = circular::next_point(at, job.radius2);
  return {job.from, job.radius2, at};
}

Work read_work(const Options& o) {
  const double scale =
      positive("--steps-per-mm", needed("--steps-per-mm", o.steps_per_mm), finest_grid);
  const auto plan = toolpath::plan(toolpath::read_gcode_file(*o.file), scale);
  Work work{fmt::format("{} at {} steps/mm", one_line(*o.file), scale), {}, {}};
  for (const toolpath::Piece& piece : plan.pieces) {
    if (const auto* line = std::get_if<toolpath::LineJob>(&piece.job)) {
      work.lines.push_back({line->major, line->minor});
    } else {
      work.arcs.push_back(arc_of(std::get<circular::Arc>(piece.job)));
    }
  }
  if (plan.pieces.empty()) {
    throw InputError(fmt::format("{}: no motion reaches a step at {} steps/mm", *o.file, scale));
  }
  if (plan.longest_line > static_cast<std::int64_t>(largest) || plan.arc_width > 16) {
    throw InputError(
        fmt::format("{}: at {} steps/mm a line or a radius is above {}", *o.file, scale, largest));
  }
  return work;
}

Work parse_work(const Options& o) {
  const int kinds = (o.line ? 1 : 0) + (o.arc ? 1 : 0) + (o.file ? 1 : 0);
  if (kinds != 1) {
    throw InputError(fmt::format("compare: one of --line, --arc and FILE is needed, {}",
                                 kinds == 0 ? "none is given" : "more are given"));
  }
  if (o.file) return read_work(o);
  if (o.steps_per_mm) throw InputError("--steps-per-mm: belongs to FILE");
  if (o.line) {
    const Line line = parse_line(*o.line);
    return {fmt::format("BP = {}, MP = {}", line.major, line.minor), {line}, {}};
  }
  const auto radius = static_cast<std::int64_t>(whole("--arc", *o.arc, 1, largest));
  const auto radius2 = static_cast<std::uint64_t>(radius * radius);
  return {fmt::format("R = {}, a quarter", radius), {}, {{{radius, 0}, radius2, {0, radius}}}};
}

compare::Machines machines_for(const Work& work, std::uint64_t seed) {
  std::int64_t longest = 0, radius = 0;
  for (const Line& line : work.lines) longest = std::max(longest, line.major);
  for (const Arc& arc : work.arcs) {
    radius = std::max(radius, std::max(circular::nearest_root(arc.radius2), arc.to.y));
  }
  compare::Machines machines;
  machines.power_up = static_cast<std::uint32_t>(seed);
  const auto bits = [](std::int64_t v) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(v)));
  };
  if (longest != 0) machines.linear = &choose(LinearShape{}, longest);
  if (radius != 0) machines.circular = &choose(CircularShape{}, bits(radius));
  machines.dda = &choose(DdaShape{}, bits(std::max(longest, radius)));
  return machines;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> names(1);
  for (const char c : text) {
    if (c == ',') {
      names.emplace_back();
    } else {
      names.back() += c;
    }
  }
  return names;
}

template <class Work>
std::string names_of(const std::vector<Algorithm<Work>>& all) {
  std::string text;
  for (const auto& a : all) text += (text.empty() ? "" : ", ") + a.name;
  return text;
}

// The algorithms asked for that draw this kind of work, all where none is asked for; and whether
// each of those asked for is known.
template <class W>
std::vector<const Algorithm<W>*> chosen(const std::vector<Algorithm<W>>& all, const Text& asked,
                                        const std::vector<W>& works, std::vector<bool>& known) {
  std::vector<const Algorithm<W>*> some;
  const auto names = asked ? split(*asked) : std::vector<std::string>{};
  for (const auto& algorithm : all) {
    const auto at = std::find(names.begin(), names.end(), algorithm.name);
    if (asked && at == names.end()) continue;
    if (asked && !works.empty()) known[static_cast<std::size_t>(at - names.begin())] = true;
    const bool can = !algorithm.can || std::all_of(works.begin(), works.end(), algorithm.can);
    if (!can && asked) {
      throw InputError(
          fmt::format("--algorithms: {} cannot draw an arc that starts at 45 degrees "
                      "or behind",
                      algorithm.name));
    }
    if (can && !works.empty()) some.push_back(&algorithm);
  }
  return some;
}

template <class W>
std::vector<Entry> contest(const char* what, const std::vector<const Algorithm<W>*>& some,
                           const compare::Machines& machines, const std::vector<W>& works) {
  std::vector<Entry> entries;
  for (const auto* algorithm : some) entries.push_back(entry_of(*algorithm, machines, works));
  if (!entries.empty()) {
    fmt::print("\n{}\n{}", count(works.size(), what), to_text(entries));
  }
  return entries;
}

void check_known(const Text& asked, const std::vector<bool>& known, const Work& work) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i]) continue;
    const std::string there = work.lines.empty()  ? names_of(compare::arc_algorithms())
                              : work.arcs.empty() ? names_of(compare::line_algorithms())
                                                  : names_of(compare::line_algorithms()) + ", " +
                                                        names_of(compare::arc_algorithms());
    throw InputError(fmt::format("--algorithms: {} cannot do this work; there are {}",
                                 cli::quoted(split(*asked)[i]), there));
  }
}

// One line or arc by every algorithm.
template <class W>
void draw(Plot& plot, const std::vector<Entry>& entries, const W& work) {
  for (const Entry& e : entries) {
    Series series{e.name, {}, {}};
    for (const circular::Point& at : e.points) {
      if (!series.points.empty() && series.points.back() == at) continue;
      series.add(at, compare::radial(work, at));
    }
    plot.series.push_back(std::move(series));
  }
}

void draw_plot_of(const std::string& path, const Work& work, const std::vector<Entry>& entries) {
  Plot plot{work.text, {}, {}};
  if (work.arcs.empty()) {
    const Line& line = work.lines.front();
    plot.ideal = ideal_line({line.major, line.minor});
    draw(plot, entries, line);
  } else {
    const Arc& arc = work.arcs.front();
    plot.ideal = ideal_arc(std::sqrt(static_cast<double>(arc.radius2)), arc.from, arc.to);
    draw(plot, entries, arc);
  }
  draw_plot(path, plot);
}

int run(const Options& o) {
  const std::uint64_t seed = o.common.seed();
  const Work work = parse_work(o);
  std::vector<bool> known(o.algorithms ? split(*o.algorithms).size() : 0, false);
  const auto by_line = chosen(compare::line_algorithms(), o.algorithms, work.lines, known);
  const auto by_arc = chosen(compare::arc_algorithms(), o.algorithms, work.arcs, known);
  check_known(o.algorithms, known, work);
  const compare::Machines machines = machines_for(work, seed);
  if (o.common.plot && o.file) throw InputError("--plot: draws one line or arc, no FILE");
  check_outputs(o.common, o.file.value_or(""));

  fmt::print("{}\n", work.text);
  std::vector<Entry> entries = contest("line", by_line, machines, work.lines);
  std::vector<Entry> arcs = contest("arc", by_arc, machines, work.arcs);
  std::move(arcs.begin(), arcs.end(), std::back_inserter(entries));

  if (o.common.plot) draw_plot_of(*o.common.plot, work, entries);

  std::vector<Outcome> outcomes;
  for (Entry& e : entries) {
    if (e.bench != nullptr) {
      e.result.failed = e.name + ", " + work.text;
      outcomes.push_back({e.bench, e.name + ", " + work.text, std::move(e.result)});
    }
  }
  fmt::print("\n");
  if (outcomes.empty()) {
    fmt::print("no machine was asked for: nothing runs in lockstep\n");
    return 0;
  }
  return conclude(outcomes, o.common, "{\"algorithms\":" + to_json(entries) + "}");
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto o = std::make_shared<Options>();
  CLI::App& command =
      *app.add_subcommand("compare", "The same work by every algorithm that can do it");
  add_text(command, "FILE", o->file, "", "A G-code program: its lines, and its arcs");
  add_text(command, "--steps-per-mm", o->steps_per_mm, "S", "Of FILE: steps of the grid to 1 mm");
  add_text(command, "--line", o->line, "BP,MP", "A line, BP at most 65535");
  add_text(command, "--arc", o->arc, "R", "A quarter circle, R at most 65535");
  add_text(command, "--algorithms", o->algorithms, "LIST", "Only these, with commas between them");
  add_plot(command, o->common);
  add_failures(command, o->common);
  add_common(command, o->common);
  command.footer(
      "axial: a line's points along its minor axis, an arc's along the axis that rests; radial:\n"
      "across the curve; end: the last point from the end; gaps: of the minor axis of a line, of\n"
      "the steps of an arc, over the ideal; kinds: combinations of steps on a clock, none "
      "included.\n"
      "Lines: " +
      names_of(compare::line_algorithms()) + ".\n" + "Arcs: " +
      names_of(compare::arc_algorithms()) + ".\n" + "Example: cosim compare --line 27,9");
  command.callback([&action, o] { action = [o] { return run(*o); }; });
}

}  // namespace cosim::cli
