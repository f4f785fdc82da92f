// A G-code program: read, planned and, where it is short, walked.
#include "model/toolpath/gcode.h"

#include <cmath>

#include "tests/fuzz/expect.h"
#include "tests/studies/toolpath/model/helpers.h"

namespace cosim::fuzz {
namespace {

constexpr double reach_mm = 1e9;
constexpr std::int64_t most_steps = 20000;  // of the path: what a walk may cost

bool in_reach(toolpath::PointMm p) {
  return std::abs(p.x) <= reach_mm && std::abs(p.y) <= reach_mm;
}

void check(const toolpath::Program& program) {
  expect(!program.motions.empty(), "a program has a motion");
  toolpath::PointMm at;
  for (const toolpath::Motion& m : program.motions) {
    expect(m.start == at, "a motion starts where the one before ended");
    expect(in_reach(m.end), "an end is in reach");
    expect(!toolpath::is_arc(m.kind) || (m.sweep > 0 && m.sweep < 6.2832), "0 < sweep <= 2 pi");
    at = m.end;
  }
}

void check(const toolpath::Plan& plan) {
  std::int64_t steps = 0;
  for (const toolpath::Piece& piece : plan.pieces) {
    steps += toolpath::steps(piece);
    if (steps > most_steps) return;
  }
  const std::string flaw = toolpath::flaw(plan, toolpath::walked(plan));
  expect(flaw.empty(), "the path is whole: " + flaw);
}

}  // namespace

FUZZ_TARGET(gcode) {
  const std::string name = "p.ngc";
  toolpath::Program program;
  if (!accepted(name, [&] { program = toolpath::read_gcode(text, name); })) return;
  check(program);
  for (const double scale : {1.0, 80.0, 1e6}) {
    toolpath::Plan plan;
    if (accepted(name, [&] { plan = toolpath::plan(program, scale); })) check(plan);
  }
}

}  // namespace cosim::fuzz
