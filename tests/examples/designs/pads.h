// Golden model of pads.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace pads_model {

using namespace cosim;
using faulty::Params;

#define PADS_INPUTS(FIELD)                                                     \
  FIELD(rst, 1, flag, "", "begin anew")                                        \
  FIELD(pull, 2, bits, "", "pads that pull the line down from the next clock") \
  FIELD(give, 1, flag, "", "drive the bus from the next clock")                \
  FIELD(value, 4, bits, "", "with this")                                       \
  FIELD(clk, 1, flag, "", "goes to the clock buffer")                          \
  FIELD(sda_in, 1, flag.at("sda$in"), "", "the line, where no pad pulls")      \
  FIELD(bus_in, 4, bits.at("bus$in"), "", "the bus, where it is not driven")
#define PADS_OUTPUTS(FIELD)                                                \
  FIELD(sda_out, 1, flag.at("sda$out"), "", "what the pads give")          \
  FIELD(sda_en, 1, flag.at("sda$en"), "", "one of them pulls")             \
  FIELD(bus_out, 4, bits.at("bus$out"), "", "what is driven, and 0 else")  \
  FIELD(bus_en, 4, bits.at("bus$en"), "", "the bits that are driven")      \
  FIELD(before, 1, flag.at("buffer$I"), "", "the clock before its buffer") \
  FIELD(lost, 1, flag, "", "somebody else pulled the line down")           \
  FIELD(seen, 4, bits, "", "what stood on the bus")
#define PADS_STATE(FIELD)                           \
  FIELD(low, 2, bits, "", "pads that pull")         \
  FIELD(giving, 1, flag, "", "the bus is driven")   \
  FIELD(seen, 4, bits, "", "what stood on the bus") \
  FIELD(lost, 1, flag, "", "the line was pulled down")
COSIM_RECORDS(PADS, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const Condition<V> pulls = !(s.low == V(0)), giving = is_set(s.giving);
  Step<V> step{s, {}};
  step.outputs = {
      V(0),   flag<V>(pulls), select(giving, s.seen, V(0)), select(giving, V(15), V(0)), in.clk,
      s.lost, s.seen};
  step.state.low = in.pull;
  step.state.giving = in.give;
  step.state.seen = select(is_set(in.give), in.value, select(giving, s.seen, in.bus_in));
  step.state.lost = flag<V>(!pulls & !is_set(in.sda_in));
  step.state = select(is_set(in.rst), State<V>{V(0), V(0), V(0), V(0)}, step.state);
  return step;
}

struct Design : faulty::Design {
  COSIM_DESIGN(pads_model);
  static constexpr const char* name = "pads";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace pads_model
