// Hostile stimulus as nets: the same function that draws the inputs of one case at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tb/nets/hostile_draw.h"
#include "tb/nets/number.h"

namespace cosim::nets {

/// A step of the stimulus.
struct DrawStep {
  Graph graph;
  std::vector<Bit> held;    ///< free: what it goes on from, the random words first
  std::vector<Bit> after;   ///< what it goes on from then
  std::vector<Bit> inputs;  ///< of a clock: the inputs that the shape has, one behind the other
};

/// What is made of the outputs of a clock, where the inputs follow from them.
struct Answer {
  Graph graph;
  std::vector<Bit> held;   ///< free: what its clock's DrawStep holds
  std::vector<Bit> seen;   ///< free: the outputs that the shape has, one behind the other
  std::vector<Bit> after;  ///< what is held then
  Bit wrong;               ///< an error, beside what differs
  std::size_t driver = 0;  ///< which of `held` is the first of the driver's
  std::vector<Bit> rest;   ///< the inputs of a clock at rest
};

struct Draw {
  std::size_t seeds = 0;  ///< words that the seeds of a case give: the first; all else is 0 then
  DrawStep clock, stretch;
  std::optional<Answer> answer{};
};

namespace detail {

template <class Design, class Act>
DrawStep draw_step(const HostilePlan<Design>& plan, Act act) {
  using Drawing = HostileDraw<Design, Number>;
  DrawStep step;
  typename Drawing::Held held;
  Drawing::visit_held(plan, held, [&](Number& value, int width) {
    std::vector<Bit> bits;
    for (int i = 0; i < width; ++i) bits.push_back(step.graph.input());
    step.held.insert(step.held.end(), bits.begin(), bits.end());
    value = Number::unsigned_code(step.graph, bits);
  });
  act(step, held);
  Drawing::visit_held(plan, held, [&](const Number& value, int width) {
    for (const Bit bit : value.code(width)) step.after.push_back(bit);
  });
  return step;
}

}  // namespace detail

template <class Design>
Draw draw_of(const typename Design::Params& p) {
  using Drawing = HostileDraw<Design, Number>;
  using Held = typename Drawing::Held;
  const HostilePlan<Design> plan(p);
  Draw draw;
  draw.seeds = plan.words + plan.stretch_words;
  draw.stretch = detail::draw_step<Design>(
      plan, [&](DrawStep&, Held& held) { Drawing::begin_stretch(plan, held); });
  draw.clock = detail::draw_step<Design>(plan, [&](DrawStep& step, Held& held) {
    typename Drawing::Inputs in;
    Drawing::clock(plan, held, in);
    const auto fields = Design::template Inputs<Word>::fields(p);
    for_each_cell<typename Drawing::Inputs>([&](auto cell, std::size_t i) {
      for (const Bit bit : cell(in).code(fields[i].width)) step.inputs.push_back(bit);
    });
  });
  return draw;
}

}  // namespace cosim::nets
