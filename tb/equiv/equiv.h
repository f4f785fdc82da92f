// Two RTLs: the same from reset on, or a stimulus that tells them apart.
//
// Both get the same inputs. For the first reset_clocks clocks the reset is active, and nothing is
// compared; afterwards it is an input like any other. Registers without an initial value begin as
// any value, the same in both where names and bits agree. Where the old RTL says x any value of the
// new one is right; an x of the new RTL has to be right for both values.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/equiv/side.h"

namespace cosim::equiv {

struct Question {
  Side gold, gate;                             ///< the old RTL and the new one
  std::string reset;                           ///< an input; empty: initial values alone
  bool reset_active = true;                    ///< the level that resets
  int reset_clocks = 3;                        ///< >= 0
  std::map<std::string, int> tied;             ///< inputs that have a value, of either side
  std::vector<std::string> ignored;            ///< outputs that are not compared
  std::map<std::string, std::string> renamed;  ///< ports of the old RTL as the new one calls them
  int latency = 0;  ///< the outputs of the new RTL come so many clocks later
  Budget budget{300};
  unsigned jobs = 4;      ///< engines at a time, >= 1
  bool verilator = true;  ///< a difference is replayed in Verilator
};

enum class Verdict { equal, different, undecided };

/// One bit of a word on one clock as it is printed.
struct Row {
  std::map<std::string, std::string> inputs;      ///< binary, the highest bit first
  std::map<std::string, std::string> gold, gate;  ///< of the outputs; '-': any value is right
};

struct Answer {
  Verdict verdict = Verdict::undecided;
  std::string by;           ///< what decided
  std::string replayed;     ///< of different: "in Verilator", or on what else, and why
  std::vector<Row> clocks;  ///< of different: the stimulus, the last row tells them apart
  std::vector<std::string> differing;  ///< of different: the outputs
  bool least = false;                  ///< of different: no shorter stimulus tells them apart
  int compared = 0;                    ///< of undecided: equal for so many clocks
  std::string left;                    ///< of undecided: what is left
  std::size_t matched = 0;             ///< registers that both have by name
};

/// Makes the gates of both sides, and compares them; a difference is replayed in Verilator.
/// InputError where the ports do not agree, before anything long; it lists them and says what to
/// write.
Answer compare(Question& question);

}  // namespace cosim::equiv
