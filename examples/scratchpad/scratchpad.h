// Golden model of scratchpad.v.
#pragma once

#include <cosim/model.h>

struct Scratchpad {
  using Word = Hex<UInt<32>>;
  using Line = Array<Word, 16>;
  struct In {
    Bit resetn;        // 0: nothing is saved
    Bit fill;          // all registers from line
    Line line;         // a line of the memory
    Bit save;          // all registers to saved
    Bit write;         // data to register target, unless all fill
    UInt<4> target;    // a register
    Word data;         // what is written
    UInt<4> source_a;  // a register
    UInt<4> source_b;  // another, or the same
  };
  struct Out {
    Line saved;  // what was last saved
    Bit fresh;   // saved is what the registers hold
    Word a;      // register source_a
    Word b;      // register source_b
  };
  static constexpr auto reset = active_low<&In::resetn>;

  At<"registers.r", Unreset<Line>> r;  // the registers
  Line saved = 0;                      // what was last saved
  Bit fresh = 0;                       // saved is what the registers hold

  Out clock(const In& in) {
    const Out out{.saved = saved, .fresh = fresh, .a = r[in.source_a], .b = r[in.source_b]};
    if (!in.resetn) {
      saved = 0;
      fresh = 0;
    } else {
      if (in.save) saved = r;
      fresh = (fresh || in.save) && !in.fill && !in.write;
    }
    if (in.fill) {
      r = in.line;
    } else if (in.write) {
      r[in.target] = in.data;
    }
    return out;
  }
};
