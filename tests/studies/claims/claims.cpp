// Measures what the sources claim and prints a table in Markdown. The machines run in lockstep with
// their models, where a row does not say otherwise. Status: 0, or 1 where a machine does not match
// or a figure is not the one known.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "model/dda/oracle.h"
#include "model/linear/control_code.h"
#include "tb/studies/comparison/contest.h"
#include "tests/studies/claims/line_table.h"

namespace cosim::compare {
namespace {

using prior_art::Point;

int status = 0;

void row(const std::string& claim, const std::string& measured, const std::string& verdict) {
  fmt::print("| {} | {} | {} |\n", claim, measured, verdict);
}

// A figure that is known from elsewhere.
void expect(const char* what, double value, double least, double most) {
  if (value >= least && value <= most) return;
  fmt::print(stderr, "{}: {:.4f} is not from {} to {}\n", what, value, least, most);
  status = 1;
}

template <class Work>
Figures drawn(const std::vector<Algorithm<Work>>& all, const std::string& name,
              const Machines& machines, const Work& work) {
  for (const auto& algorithm : all) {
    if (algorithm.name != name) continue;
    const Entry entry = entry_of(algorithm, machines, std::vector<Work>{work});
    if (!entry.result.match()) throw std::runtime_error(name + ": RTL and model differ");
    return entry.figures;
  }
  throw std::logic_error("no algorithm " + name);
}

template <class Design, class Is>
const Bench<Design>& bench(Is is) {
  for (const auto* one : benches_of<Design>()) {
    if (is(one->params())) return *one;
  }
  throw std::logic_error(std::string(Design::name) + " was not built in the width");
}

// ---- Lines of m = 8, gamma = 3 ------------------------------------------------------------------

constexpr int m = 8;

// What is said of one algorithm over all lines.
struct OverLines {
  Figures sum;
  double ratio_sum = 0, worst_ratio = 0;  // of its clocks to those of the prototype
  double mean_error = 0;                  // of the lines' largest deviations
  int better = 0, worse = 0;              // than the prototype
};

std::map<std::string, OverLines> over_lines(int& lines) {
  Machines machines;
  machines.linear = &bench<linear::Design>([](auto p) {
    const auto sizes = linear::sizes_of(p);
    return sizes.m == m && sizes.gamma() == 3;
  });
  machines.dda = &bench<dda::Design>([](auto p) { return dda::width_of(p) == m; });
  std::map<std::string, OverLines> all;
  for (Line line{1, 0}; line.major < 1 << m; ++line.major) {
    for (line.minor = 0; line.minor <= line.major; ++line.minor, ++lines) {
      const Figures prototype = drawn(line_algorithms(), "rate-multiplier", machines, line);
      for (const char* name : {"su1631518", "su1631518-greedy", "rate-multiplier", "dda"}) {
        const Figures f = drawn(line_algorithms(), name, machines, line);
        OverLines& o = all[name];
        o.sum.add(f);
        const double ratio = static_cast<double>(f.clocks) / static_cast<double>(prototype.clocks);
        o.ratio_sum += ratio;
        o.worst_ratio = std::max(o.worst_ratio, ratio);
        o.mean_error += f.axial.largest;
        constexpr double equal = 1e-9;
        o.better += f.axial.largest < prototype.axial.largest - equal;
        o.worse += f.axial.largest > prototype.axial.largest + equal;
      }
    }
  }
  return all;
}

void claims_of_lines() {
  int lines = 0;
  auto all = over_lines(lines);
  const auto count = static_cast<double>(lines);
  const OverLines& best = all["su1631518"];
  const OverLines& greedy = all["su1631518-greedy"];
  const OverLines& prototype = all["rate-multiplier"];

  row("SU 1631518: ceil(BP / 2^gamma) clocks in place of 2^m / 2^gamma",
      fmt::format("all {} lines of m = 8, gamma = 3: {:.2f} of the prototype's clocks on average, "
                  "{:.2f} at worst",
                  lines, best.ratio_sum / count, best.worst_ratio),
      best.worst_ratio < 1 ? "holds" : "holds; no gain where BP > 2^m - 2^gamma");
  expect("worst ratio", best.worst_ratio, 1, 1);

  row("two combinations of steps in place of four",
      fmt::format("{} and {} over all these lines", best.sum.combinations_used(),
                  prototype.sum.combinations_used()),
      best.sum.combinations_used() == 2 && prototype.sum.combinations_used() == 4
          ? "holds"
          : "does not hold");
  expect("combinations", best.sum.combinations_used(), 2, 2);

  for (const auto& [name, o] : {std::pair{"best code", best}, std::pair{"greedy code", greedy}}) {
    row(fmt::format("a smaller error than the prototype's, {}", name),
        fmt::format(
            "largest axial error: mean {:.3f} in place of {:.3f}, worst {:.3f} in place of "
            "{:.3f}, over all points RMS {:.3f} in place of {:.3f}; smaller in {:.0f} %, larger in "
            "{:.0f} % of the lines",
            o.mean_error / count, prototype.mean_error / count, o.sum.axial.largest,
            prototype.sum.axial.largest, o.sum.axial.rms(), prototype.sum.axial.rms(),
            100 * o.better / count, 100 * o.worse / count),
        o.worse == 0                                     ? "holds"
        : o.sum.axial.rms() >= prototype.sum.axial.rms() ? "does not hold"
        : o.mean_error < prototype.mean_error            ? "holds on average, not for every line"
                                                         : "holds for the RMS error, not for "
                                                           "the largest of a line");
  }
  const OverLines& dda = all["dda"];
  row("DDA: at most one step off, a line",
      fmt::format("all these lines: {:.3f} steps", dda.sum.axial.largest),
      dda.sum.axial.largest < 1 ? "holds" : "does not hold");
  expect("a linear DDA", dda.sum.axial.largest, 0.98, 1);
}

void worst_codes() {
  std::string text;
  const std::map<int, std::pair<double, double>> known{{5, {1.33, 1.27}}, {8, {2.15, 2.14}}};
  for (const auto& [bits, figures] : known) {
    double worst_greedy = 0, worst_best = 0;
    for (std::int64_t major = 1 << (bits - 1); major < 1 << bits; ++major) {
      for (std::int64_t minor = 0; minor <= major; ++minor) {
        const auto off = [&, m = bits](linear::Code code) {
          return linear::max_deviation(m, major, code).value();
        };
        worst_greedy = std::max(worst_greedy, off(linear::greedy_code(bits, major, minor)));
        worst_best = std::max(worst_best, off(linear::best_code(bits, major, minor)));
      }
    }
    text += fmt::format("{}m = {}: {:.2f} greedy, {:.2f} best", text.empty() ? "" : "; ", bits,
                        worst_greedy, worst_best);
    expect("worst greedy", worst_greedy, figures.first - 0.006, figures.first + 0.006);
    expect("worst best", worst_best, figures.second - 0.006, figures.second + 0.006);
  }
  row("(not claimed) its worst error over BP >= 2^(m-1), of its codes", text,
      "a Bresenham line stays within 0.5");
}

// The largest deviations of the DDA's four ways.
struct OfDda {
  double parallel, parallel_half, sequential, sequential_half;
};

void row_of_dda(const std::string& claim, const std::string& over, const OfDda& worst) {
  const double others = std::max({worst.parallel, worst.parallel_half, worst.sequential});
  row(claim,
      fmt::format("{}: parallel {:.2f}, parallel from half {:.2f}, sequential {:.2f}, sequential "
                  "from half {:.2f} steps",
                  over, worst.parallel, worst.parallel_half, worst.sequential,
                  worst.sequential_half),
      others < 1                  ? "holds"
      : worst.sequential_half < 1 ? "holds, of the four, sequentially from half alone"
                                  : "does not hold");
}

// ---- Circles ------------------------------------------------------------------------------------

void claims_of_circles() {
  Machines machines;
  machines.circular = &bench<circular::Design>([](auto p) { return circular::width_of(p) == 8; });
  machines.dda = &bench<dda::Design>([](auto p) { return dda::width_of(p) == 8; });
  std::map<std::string, Figures> all;
  Figures early;  // the prototype to 45 degrees
  for (std::int64_t radius = 2; radius < 256; ++radius) {
    const auto radius2 = static_cast<std::uint64_t>(radius * radius);
    const Arc quarter{{radius, 0}, radius2, {0, radius}};
    for (const auto& algorithm : arc_algorithms()) {
      all[algorithm.name].add(drawn(arc_algorithms(), algorithm.name, machines, quarter));
    }
    // The last row before the diagonal.
    const auto row =
        static_cast<std::int64_t>(std::floor(static_cast<double>(radius) / std::sqrt(2.0))) - 1;
    const Arc eighth{{radius, 0}, radius2, {circular::nearest_on(row, radius2), row}};
    early.add(drawn(arc_algorithms(), "su875343", machines, eighth));
  }
  const Figures& circle = all["su1665343"];
  row("SU 1665343: at most half a step off",
      fmt::format("all R from 2 to 255: axial {:.4f}, radial {:.4f} steps", circle.axial.largest,
                  circle.radial.largest),
      circle.axial.largest < 0.5 ? "holds" : "does not hold");
  expect("circle", circle.axial.largest, 0.49, 0.5);
  row("a step on every clock",
      fmt::format("{} steps on {} clocks in {} arcs", circle.steps, circle.clocks, circle.paths),
      circle.clocks == circle.steps                  ? "holds"
      : circle.clocks == circle.steps + circle.paths ? "holds but for one clock at 45 degrees"
                                                     : "does not hold");
  expect("clocks without a step", static_cast<double>(circle.clocks - circle.steps),
         static_cast<double>(circle.paths), static_cast<double>(circle.paths));
  const Figures& prototype = all["su875343"];
  row("a whole quadrant in place of 45 degrees",
      fmt::format("the prototype: {:.3f} steps off to 45 degrees, {:.1f} to the end",
                  early.axial.largest, prototype.radial.largest),
      early.axial.largest < 0.5 && prototype.radial.largest > 1 && circle.radial.largest < 0.5
          ? "holds"
          : "does not hold");

  const auto worst_of = [&](const char* name) { return all[name].radial.largest; };
  row_of_dda("DDA: at most one step off, a quarter circle", "all R from 2 to 255, radial",
             {worst_of("dda"), worst_of("dda-half"), worst_of("dda-sequential"),
              worst_of("dda-sequential-half")});
}

// By the sums of the oracle: 10 bits is no width that is built. A parallel turn gains about pi R /
// 2^W of radius, and leaves 10 bits where R is more.
void claim_of_a_turn() {
  constexpr int width = 10;
  constexpr std::int64_t least = 512, most = 1018;
  const auto worst_of = [&](dda::Update update, dda::Preload preload) {
    double worst = 0;
    for (std::int64_t radius = least; radius <= most; ++radius) {
      const dda::Job job = dda::circle(width, radius, {update, preload, false});
      for (dda::Track track(width, job); track.next();) {
        const double at =
            std::hypot(static_cast<double>(track.at().x), static_cast<double>(track.at().y));
        worst = std::max(worst, std::fabs(at - static_cast<double>(radius)));
      }
    }
    return worst;
  };
  using enum dda::Update;
  using enum dda::Preload;
  const OfDda worst{worst_of(parallel, zero), worst_of(parallel, half), worst_of(sequential, zero),
                    worst_of(sequential, half)};
  row_of_dda("the same, a full turn, by its oracle",
             fmt::format("10 bits, all R from {} to {}, radial", least, most), worst);
  expect("parallel turn", worst.parallel, 3.9, 4.5);
  expect("sequential turn", worst.sequential, 1.3, 1.7);
}

}  // namespace
}  // namespace cosim::compare

int main() {
  using namespace cosim::compare;
  try {
    fmt::print("| claim | measured | verdict |\n| --- | --- | --- |\n");
    claims_of_lines();
    worst_codes();
    claims_of_circles();
    claim_of_a_turn();
    fmt::print("\n");
    return cosim::claims::print_line_table() ? status : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "claims: {}\n", error.what());
    return 1;
  }
}
