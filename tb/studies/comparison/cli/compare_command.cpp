#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <memory>

#include "model/circular/oracle.h"
#include "model/core/input_error.h"
#include "model/toolpath/quantise.h"
#include "tb/cli/command.h"
#include "tb/cli/common.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"
#include "tb/cli/outputs.h"
#include "tb/cli/registry.h"
#include "tb/designs/circular/cli/shape.h"
#include "tb/designs/dda/cli/shape.h"
#include "tb/designs/linear/cli/shape.h"
#include "tb/studies/comparison/contest.h"
#include "tb/studies/toolpath/cli/curves.h"
#include "tb/studies/toolpath/pieces.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

using compare::Algorithm;
using compare::Arc;
using compare::Entry;
using compare::Line;

// The work is one line, one arc, or all those of a program.
struct CompareOptions {
  Common common;
  Text file, steps_per_mm, line, arc;
  Text algorithms;
};

struct NamedWork {
  std::string text;  // what it is, one line
  pieces::Work pieces;
};

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
  return {fmt::format("{} at {} steps/mm", one_line(file), scale), pieces::work_of(plan)};
}

NamedWork parse_work(const CompareOptions& o) {
  const int kinds = (o.line ? 1 : 0) + (o.arc ? 1 : 0) + (o.file ? 1 : 0);
  if (kinds != 1) {
    throw InputError(fmt::format("compare: one of --line, --arc and FILE is needed, {}",
                                 kinds == 0 ? "none is given" : "more are given"));
  }
  if (o.file) return read_work(*o.file, o.steps_per_mm);
  if (o.steps_per_mm) throw InputError("--steps-per-mm: belongs to FILE");
  if (o.line) {
    const Line line = parse_line(*o.line);
    return {fmt::format("BP = {}, MP = {}", line.major, line.minor), pieces::work_of(line)};
  }
  const auto radius = static_cast<std::int64_t>(whole("--arc", *o.arc, 1, largest_major));
  const Arc quarter{{radius, 0}, static_cast<std::uint64_t>(radius * radius), {0, radius}};
  return {fmt::format("R = {}, a quarter", radius), pieces::work_of(quarter)};
}

compare::Machines machines_for(const pieces::Work& work, std::uint64_t seed) {
  std::int64_t longest = 0, radius = 0;
  for (const Line& line : work.lines.works) longest = std::max(longest, line.major);
  for (const Arc& arc : work.arcs.works) {
    radius = std::max(radius, std::max(circular::nearest_root(arc.radius2), arc.to.y));
  }
  compare::Machines machines;
  machines.power_up = static_cast<std::uint32_t>(seed);
  const auto bits = [](std::int64_t v) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(v)));
  };
  if (longest != 0) machines.linear = &linear::bench_for({}, longest);
  if (radius != 0) machines.circular = &circular::bench_for({}, bits(radius));
  machines.dda = &dda::bench_for({}, bits(std::max(longest, radius)));
  return machines;
}

// At least one name, which may be empty.
std::vector<std::string> split(const std::string& text) { return parts_in(text + ',', ','); }

template <class Work>
std::string names_of(const std::vector<Algorithm<Work>>& all) {
  std::string text;
  for (const auto& a : all) text += (text.empty() ? "" : ", ") + a.name;
  return text;
}

// The algorithms that draw all the work of one kind, and a line on each that cannot.
template <class W>
struct Choice {
  std::vector<const Algorithm<W>*> some;
  std::string left_out;
};

// Of those asked for, of all where none is asked for; and whether each of those asked for is known.
template <class W>
Choice<W> chosen(const std::vector<Algorithm<W>>& all, const Text& asked,
                 const std::vector<W>& works, std::vector<bool>& known) {
  Choice<W> choice;
  if (works.empty()) return choice;
  const auto names = asked ? split(*asked) : std::vector<std::string>{};
  for (const auto& algorithm : all) {
    const auto at = std::ranges::find(names, algorithm.name);
    if (asked && at == names.end()) continue;
    if (asked) known[static_cast<std::size_t>(at - names.begin())] = true;
    if (!algorithm.can || std::ranges::all_of(works, algorithm.can)) {
      choice.some.push_back(&algorithm);
      continue;
    }
    const std::string why = fmt::format("{} cannot draw {}", algorithm.name, algorithm.cannot);
    if (asked) throw InputError("--algorithms: " + why);
    choice.left_out += "left out: " + why + "\n";
  }
  return choice;
}

// An algorithm of lines and of arcs is one path.
Series& series_of(Plot& plot, const std::string& name) {
  const auto at = std::ranges::find(plot.series, name, &Series::name);
  return at != plot.series.end() ? *at : plot.series.emplace_back(Series{name, {}});
}

// Adds the points that were drawn of a piece, each once: spread evenly over the piece's part of the
// path, so that algorithms of more and of fewer steps stand at the same places.
template <class W>
void add_points(Series& series, const W& work, const pieces::Place& place, compare::Points points) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const double last = std::max(1.0, static_cast<double>(points.size()) - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const prior_art::Point d = place.orientation.to_plane(points[i]);
    series.add({{place.origin.x + d.x, place.origin.y + d.y},
                compare::radial(work, points[i]),
                place.begin + place.steps * static_cast<double>(i) / last});
  }
}

// Draws into the picture, where there is one. The table goes to `looks`, too.
template <class W>
std::vector<Entry> contest(const char* what, const Choice<W>& choice,
                           const compare::Machines& machines, const pieces::Batch<W>& batch,
                           Plot* plot, Looks& looks) {
  std::vector<Entry> entries;
  for (const auto* algorithm : choice.some) {
    compare::PointsSink sink;
    if (plot != nullptr) {
      sink = [&, &series = series_of(*plot, algorithm->name)](std::size_t i, const auto& points) {
        add_points(series, batch.works[i], batch.places[i], points);
      };
    }
    entries.push_back(entry_of(*algorithm, machines, batch.works, sink));
  }
  if (!entries.empty()) {
    looks.push_back({count(batch.works.size(), what), choice.left_out});
    looks.back().table = to_text(entries);
    fmt::print("\n{}\n{}{}", looks.back().heading, looks.back().table, choice.left_out);
  }
  return entries;
}

// Of a program with both, what an algorithm draws that has no part in the other.
void name_parts(Plot& plot, const std::vector<Entry>& lines, const std::vector<Entry>& arcs) {
  const auto among = [](const std::vector<Entry>& entries, const Series& series) {
    return std::ranges::any_of(entries, [&](const Entry& e) { return e.name == series.name; });
  };
  for (Series& series : plot.series) {
    const bool line = among(lines, series), arc = among(arcs, series);
    if (line != arc) series.name += line ? " (lines)" : " (arcs)";
  }
}

void check_known(const Text& asked, const std::vector<bool>& known, const pieces::Work& work) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i]) continue;
    const std::string there =
        work.lines.works.empty() ? names_of(compare::arc_algorithms())
        : work.arcs.works.empty()
            ? names_of(compare::line_algorithms())
            : names_of(compare::line_algorithms()) + ", " + names_of(compare::arc_algorithms());
    throw InputError(fmt::format("--algorithms: {} cannot do this work; there are {}",
                                 in_quotes(split(*asked)[i]), there));
  }
}

void check_once(const std::vector<std::string>& names) {
  for (auto at = names.begin(); at != names.end(); ++at) {
    if (std::find(names.begin(), at, *at) != at) {
      throw InputError(fmt::format("--algorithms: {} is given twice", in_quotes(*at)));
    }
  }
}

int run(const CompareOptions& o) {
  const std::uint64_t seed = o.common.seed();
  const auto [text, work] = parse_work(o);
  if (o.algorithms && o.algorithms->empty()) throw InputError("--algorithms: names none");
  if (o.algorithms) check_once(split(*o.algorithms));
  std::vector<bool> known(o.algorithms ? split(*o.algorithms).size() : 0, false);
  const auto by_line = chosen(compare::line_algorithms(), o.algorithms, work.lines.works, known);
  const auto by_arc = chosen(compare::arc_algorithms(), o.algorithms, work.arcs.works, known);
  check_known(o.algorithms, known, work);
  const compare::Machines machines = machines_for(work, seed);
  check_outputs(o.common, {o.file.value_or("")});

  Plot plot{text, {}, {}};
  Plot* const drawn = o.common.plot ? &plot : nullptr;
  fmt::print("{}\n", text);
  Looks looks;
  std::vector<Entry> entries = contest("line", by_line, machines, work.lines, drawn, looks);
  std::vector<Entry> arcs = contest("arc", by_arc, machines, work.arcs, drawn, looks);
  if (drawn != nullptr) {
    plot.ideal = curves_of(work);
    if (!entries.empty() && !arcs.empty()) name_parts(plot, entries, arcs);
    draw_plot(*o.common.plot, plot);
  }
  std::move(arcs.begin(), arcs.end(), std::back_inserter(entries));

  std::vector<Outcome> outcomes;
  for (Entry& e : entries) {
    if (e.bench != nullptr) {
      e.result.failed = e.name + ", " + text;
      outcomes.push_back({e.bench, e.name + ", " + text, std::move(e.result)});
    }
  }
  fmt::print("\n");
  const std::string figures = "{\"algorithms\":" + to_json(entries) + "}";
  if (outcomes.empty()) fmt::print("no machine was asked for: nothing runs in lockstep\n");
  return conclude(outcomes, o.common, figures, std::move(looks), text);
}

void add_compare(const Command& program) {
  auto o = std::make_shared<CompareOptions>();
  const Command command =
      program.sub("compare", "The same line, arc or program by every algorithm that can do it");
  command.argument("FILE", o->file, "A G-code program: its lines, and its arcs");
  command.text("--steps-per-mm", o->steps_per_mm, "S",
               "Needed with FILE: steps of the grid to 1 mm");
  command.text("--line", o->line, "BP,MP", fmt::format("A line, BP at most {}", largest_major));
  command.text("--arc", o->arc, "R", fmt::format("A quarter circle, R at most {}", largest_major));
  command.text("--algorithms", o->algorithms, "LIST", "Only these, with commas between them");
  add_plot(command, o->common);
  add_html(command, o->common, "the figures");
  add_failures(command, o->common);
  add_common(command, o->common);
  command.footer(
      "axial: how far the points are off along one axis, of a line its minor axis; radial: across\n"
      "the curve. end: how far the last point is from the end asked for. gaps: the shortest and "
      "the\n"
      "longest way from step to step over the ideal one, of a line on its minor axis. kinds: how\n"
      "many combinations of steps occur on a clock, the one without a step included.\n"
      "Lines: " +
      names_of(compare::line_algorithms()) + "\nArcs: " + names_of(compare::arc_algorithms()) +
      "\nExample: cosim compare --line 27,9");
  command.action([o] { return run(*o); });
}

}  // namespace
}  // namespace cosim::cli

namespace cosim::comparison {

void add_to(cli::Registry& registry) { registry.command(cli::add_compare); }

}  // namespace cosim::comparison
