#include <fmt/format.h>

#include <memory>

#include "model/circular/arc.h"
#include "model/core/input_error.h"
#include "tb/check.h"
#include "tb/cli/choose.h"
#include "tb/cli/command.h"
#include "tb/cli/conclude.h"
#include "tb/cli/number.h"
#include "tb/cli/shape_options.h"
#include "tb/output_file.h"
#include "tb/table.h"

namespace cosim::cli {
namespace {

constexpr std::uint64_t largest_coordinate = 0xffffffff;

struct Options {
  Common common;
  std::string from, radius, radius2, count;
  ShapeOptions shape;
};

circular::Point parse_point(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw InputError(fmt::format("--from: '{}' is not X,Y", text));
  }
  return {static_cast<std::int64_t>(whole("--from", text.substr(0, comma), 0, largest_coordinate)),
          static_cast<std::int64_t>(whole("--from", text.substr(comma + 1), 0, largest_coordinate))};
}

// The point of the same row or column that is next to the circle, where there is one.
std::string suggestion(const circular::Arc& arc) {
  circular::Point p = arc.from;
  (p.x > p.y ? p.x : p.y) = circular::nearest_on(std::min(p.x, p.y), arc.radius2);
  return circular::next_to_circle(p, arc.radius2) ? fmt::format("; ({}, {}) is", p.x, p.y) : "";
}

circular::Arc parse_arc(const Options& o) {
  if (o.radius.empty() == o.radius2.empty()) {
    throw InputError("--radius or --radius2: exactly one of them is needed");
  }
  circular::Arc arc;
  if (o.radius.empty()) {
    arc.radius2 = whole("--radius2", o.radius2, 0, largest_coordinate * largest_coordinate);
  } else {
    const std::uint64_t r = whole("--radius", o.radius, 0, largest_coordinate);
    arc.radius2 = r * r;
  }
  arc.from = {circular::nearest_root(arc.radius2), 0};
  if (!o.from.empty()) arc.from = parse_point(o.from);
  if (!circular::next_to_circle(arc.from, arc.radius2)) {
    throw InputError(fmt::format("--from: ({}, {}) is not next to the circle of R^2 = {}{}",
                                 arc.from.x, arc.from.y, arc.radius2, suggestion(arc)));
  }
  if (!o.count.empty()) {
    arc.count = static_cast<std::int64_t>(whole("--count", o.count, 0, std::uint64_t{1} << 40));
  }
  return arc;
}

class Rows final : public Observer<circular::Design> {
 public:
  Rows(OutputFile& file, circular::Point from) : file_(file), at_(from) {}
  void clock(std::size_t, const Compared<circular::Design>& seen) override {
    if (seen.outputs.running) ++clock_;
    if (!(seen.outputs.step_x | seen.outputs.step_y)) return;
    at_ = {at_.x - seen.outputs.step_x, at_.y + seen.outputs.step_y};
    file_.line("{},{},{},{},{}", clock_, -seen.outputs.step_x, seen.outputs.step_y, at_.x, at_.y);
  }

 private:
  OutputFile& file_;
  circular::Point at_;
  std::uint64_t clock_ = 0;
};

int run(const Options& o) {
  const std::uint64_t seed = o.common.seed();
  const circular::Arc arc = parse_arc(o);
  const auto& bench = choose(o.shape.circular(), circular::width_needed(arc.radius2));

  const std::string work = fmt::format(
      "R^2 = {} from ({}, {}){}", arc.radius2, arc.from.x, arc.from.y,
      arc.count ? fmt::format(", stopped after {} steps", *arc.count) : std::string());
  fmt::print("{}: {}\n", bench.title(), work);

  OutputFile csv(o.common.csv);
  csv.line("clock,dx,dy,x,y");
  ArcCheck check({&arc, 1});
  Rows rows(csv, arc.from);
  Observers<circular::Design> observers{&check, &rows};
  std::unique_ptr<Table<circular::Design>> table;
  if (o.common.table) {
    observers.add(*(table = std::make_unique<Table<circular::Design>>(bench.params())));
  }

  Run run = bench.open(static_cast<std::uint32_t>(seed))->draw({&arc, 1}, observers);
  csv.close();
  Outcome outcome{&bench, work, {}};
  outcome.result.clocks = run.clocks;
  outcome.result.cases = 1;
  outcome.result.mismatch = std::move(run.mismatch);
  outcome.result.checked = outcome.result.mismatch ? check.so_far() : check.finish();
  outcome.result.failed = work;
  return conclude({outcome}, o.common);
}

}  // namespace

void add_arc(CLI::App& app, Action& action) {
  auto o = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "arc", "An arc in the first quadrant, anticlockwise, on the circular machine");
  command->add_option("--radius", o->radius, "R in steps, 0 to 2^32 - 1")->type_name("R");
  command->add_option("--radius2", o->radius2, "R^2, where R is not whole")->type_name("Q");
  command->add_option("--from", o->from, "A lattice point next to the circle; default R,0")
      ->type_name("X,Y");
  command->add_option("--count", o->count, "Stop after K steps through input 32")->type_name("K");
  o->shape.add_circular(*command);
  add_csv(*command, o->common, "clock,dx,dy,x,y");
  add_table(*command, o->common);
  add_common(*command, o->common);
  command->callback([&action, o] { action = [o] { return run(*o); }; });
}

}  // namespace cosim::cli
