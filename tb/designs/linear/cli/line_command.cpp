#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "model/core/input_error.h"
#include "model/linear/oracle.h"
#include "tb/cli/command.h"
#include "tb/cli/common.h"
#include "tb/cli/draw_one.h"
#include "tb/cli/number.h"
#include "tb/cli/registry.h"
#include "tb/designs/linear/cli/code_option.h"
#include "tb/designs/linear/cli/shape.h"
#include "tb/designs/linear/figures.h"
#include "tb/designs/linear/sweeps.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t most_steps = 0xffffffff;

struct LineOptions {
  Common common;
  Text major, minor, code;
  ShapeOptions shape{linear::shape_options()};
};

std::optional<std::int64_t> parse_minor(const Text& text, std::int64_t major) {
  if (!text) return {};
  const auto minor = static_cast<std::int64_t>(whole("--minor", *text, 0, most_steps));
  if (minor > major) {
    throw InputError(fmt::format("--minor: {} is more than --major {} (MP <= BP)", minor, major));
  }
  return minor;
}

class Rows final : public Observer<linear::Design> {
 public:
  Rows(OutputFile& file, int word) : file_(file), word_(word) { file_.line("tick,major,minor"); }
  void clock(std::size_t, const Compared<linear::Design>& seen) override {
    const auto out = linear::out_of(seen.outputs);
    if (!out.strobe) return;
    file_.line("{},{:0{}b},{:0{}b}", ++tick_, static_cast<std::uint64_t>(out.major), word_,
               static_cast<std::uint64_t>(out.minor), word_);
  }

 private:
  OutputFile& file_;
  int word_;
  std::uint64_t tick_ = 0;
};

// Where nobody names M, a code's bits do, if there is such a machine.
Shape shape_of(const LineOptions& o) {
  Shape shape = o.shape.shape();
  const std::optional<int> width = width_of(o.code);
  const auto is_m = [](const Parameter& p) { return std::string(p.name) == "M"; };
  if (!width || std::ranges::any_of(shape, is_m)) return shape;
  const auto found = matching<linear::Design>(shape);
  if (std::ranges::any_of(found, [&](const auto* bench) {
        return linear::sizes_of(bench->params()).m == *width;
      })) {
    shape.push_back({"M", *width});
  }
  return shape;
}

int run(const LineOptions& o) {
  const auto power_up = static_cast<std::uint32_t>(o.common.seed());
  const auto major =
      static_cast<std::int64_t>(whole("--major", needed("--major", o.major), 0, most_steps));
  const std::optional<std::int64_t> minor = parse_minor(o.minor, major);
  const auto& bench = linear::bench_for(shape_of(o), major);
  const linear::Sizes sizes = linear::sizes_of(bench.params());
  const ChosenCode code = choose_code(o.code, sizes.m, major, minor);
  const auto words = static_cast<std::uint64_t>(linear::ticks(sizes.gamma(), major));
  const Extent extent{words, static_cast<std::uint64_t>(major), words,
                      digits(words) + 2 * static_cast<std::size_t>(sizes.word()) + 3};
  const std::string work =
      fmt::format("BP = {}, MP = {}, UK = {:0{}b}{}", major, code.minor, code.code, sizes.m,
                  code.rule.empty() ? "" : " (" + code.rule + ")");
  const linear::Job job{{major, code.code}, {}};
  return draw_one<linear::Design, linear::LineFigures>(
      {o.common,
       power_up,
       bench,
       work,
       job,
       extent,
       [&](OutputFile& csv) { return std::make_unique<Rows>(csv, sizes.word()); },
       {0, 0},
       [&](GridPoint at) { return linear::deviation(major, code.minor, at.x, at.y); },
       [&](const auto&) -> Curve {
         return {{0, 0}, {static_cast<double>(major), static_cast<double>(code.minor)}};
       }});
}

void add_line(const Command& program) {
  auto o = std::make_shared<LineOptions>();
  const Command command = program.sub("line", "A straight line on the linear machine");
  command.text("--major", o->major, "BP", "Needed: steps on the major axis, 0 to 2^M - 1");
  command.text("--minor", o->minor, "MP",
               "Steps on the minor axis, 0 to BP; needed unless --code gives bits");
  command.text("--code", o->code, "UK",
               "Control code: best (default), greedy, M bits such as 01010, or 0x0a");
  o->shape.add(command);
  add_drawing(command, o->common,
              "Write tick,major,minor: a row a strobe, words in bits, first step leftmost");
  command.footer("Example: cosim line --major 27 --minor 9");
  command.action([o] { return run(*o); });
}

}  // namespace
}  // namespace cosim::cli

namespace cosim::linear {
namespace {

std::vector<Sweep> exhaustive(const LinearBench& bench, bool in_lanes) {
  const int widest = in_lanes ? 14 : 8;
  if (sizes_of(bench.params()).m > widest) return {};
  return {every_line(bench)};
}

}  // namespace

void add_to(cli::Registry& registry) {
  registry.command(cli::add_line);
  registry.sweeps({Design::name, "Lines on the linear machine", "--random 1000 --seed 7",
                   shape_options(), cli::for_bench_of<Design>(exhaustive),
                   "M <= 8, or 14 with --lanes auto", cli::for_bench_of<Design>(random_lines)});
  registry.example({"Linear interpolator: BP = 27, MP = 9, code 01010",
                    {"line", "--major", "27", "--minor", "9", "--code", "01010", "--m", "5", "--n",
                     "2", "--table"}});
}

}  // namespace cosim::linear
