// Two RTLs: the same from reset on, or a stimulus that tells them apart.
//
// Both get the same inputs. For the first reset_clocks clocks the reset is active, and nothing is
// compared; afterwards it is an input like any other. Registers without an initial value begin as
// any value, the same in both where names and bits agree. Where the old RTL says x any value of the
// new one is right; an x of the new RTL has to be right for both values.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/equiv/referee.h"
#include "tb/equiv/side.h"
#include "tb/proof/invariant.h"

namespace cosim::equiv {

// What is assumed of the ports: expressions of Verilog that are true on every clock after the
// reset.
struct Assumption {
  std::string text;                ///< as it was given
  Side logic;                      ///< the module below as gates: its inputs are ports
  std::string verilog;             ///< the module `name`, with the output cosim_holds
  std::string name;                ///< of no other one
  std::vector<std::string> ports;  ///< of the old RTL, that it names
  bool of_outputs = false;         ///< some are outputs: those of the old RTL
};

/// InputError "--assume: ...", one line, where a text is no expression of Verilog, names what is no
/// port of `gold`, or names the clock. OutOfTime.
std::vector<Assumption> assumptions(const std::vector<std::string>& texts, const Side& gold,
                                    const Budget& budget);

struct Question;
/// InputError where no stimulus keeps to the question's assumptions: anything would be equal then.
/// Those of inputs alone are looked at for all clocks, others for the first 20 after the reset.
/// False where it is not known. To be called when the gates are made.
bool are_met(Question& question);

struct Question {
  Side gold, gate;  ///< the old RTL and the new one
  /// The inputs that are to reset, and the level that does, where it is given. Empty:
  /// find_resets() does.
  std::map<std::string, std::optional<bool>> wanted_resets{};
  /// Those that do, and the level; empty: initial values alone. None while they are not known.
  std::optional<std::map<std::string, bool>> resets{};
  int reset_clocks = 3;  ///< >= 0
  /// Inputs that have a value, of either side: binary, the highest bit first, no wider than the
  /// input.
  std::map<std::string, std::string> tied{};
  std::map<std::string, std::string> same{};     ///< registers of the old RTL by other names
  std::vector<std::string> ignored{};            ///< outputs that are not compared
  std::map<std::string, std::string> renamed{};  ///< ports of the old RTL as the new one calls them
  std::vector<Assumption> assumed{};             ///< of the clocks after the reset
  /// There are several clocks. Each is an input that says whether it takes its edge on a step, and
  /// what is called a clock elsewhere is a step. All take theirs while it resets.
  bool steps = false;
  int latency = 0;  ///< the outputs of the new RTL come so many clocks later
  Budget budget{300};
  /// A proof is checked for as long as it took, but no less and no more than so long.
  std::chrono::seconds check_least{2}, check_most{10};
  std::filesystem::path keep{};     ///< a folder for what the engines are asked; empty: nowhere
  unsigned jobs = 4;                ///< engines at a time, >= 1
  bool verilator = true;            ///< a difference is replayed in Verilator
  std::uint64_t wave_before = 200;  ///< clocks that a wave shows before a difference
};

enum class Verdict { equal, different, undecided };

/// The words of one clock as they are printed.
struct Row {
  std::map<std::string, std::string> inputs;      ///< binary, the highest bit first
  std::map<std::string, std::string> gold, gate;  ///< of the outputs; '-': any value is right
};

/// An output whose values are the same in the same order, but not on the same clocks.
struct Late {
  std::string port;
  int clocks = 0;  ///< that the new one is later; < 0: earlier
};

/// What Verilator recorded of a difference, files of it (vcd.h); empty where it did not.
struct Recorded {
  std::string gold, gate;
};

/// How a side was read, and whether that is what its source says.
struct Trusted {
  FrontEnd front_end = FrontEnd::yosys;
  Refereed is;
};

struct Answer {
  Trusted gold_read, gate_read;  ///< empty where both have the same source
  Verdict verdict = Verdict::undecided;
  std::string by;  ///< what decided
  /// Of equal, where one engine of abc or sequential reasoning decided: the check of it.
  std::optional<proof::Invariant> check;
  std::string replayed;     ///< of different: "in Verilator", or on what else, and why
  std::vector<Row> clocks;  ///< of different: the stimulus, the last row tells them apart
  /// Of different: what comes of it where the inputs stay as they are, at most clocks_behind, and
  /// only as long as what is assumed holds.
  std::vector<Row> after;
  std::vector<std::string> differing;  ///< of different: the outputs
  /// Of different, where on these clocks only the time differs: the outputs that differ on one.
  std::vector<Late> late;
  Recorded recorded;  ///< of different: from first_drawn() on
  /// Of different: what each register begins as, a digit each; 'x': it may be any.
  std::string gold_begins, gate_begins;
  bool least = false;       ///< of different: no shorter stimulus tells them apart
  int compared = 0;         ///< of undecided: equal for so many clocks
  std::string left;         ///< of undecided: what is left
  std::size_t matched = 0;  ///< registers that both have by name
  /// Registers of the old RTL that the new one has by another name.
  std::map<std::string, std::string> renamed{};
};

/// How many clocks a stimulus has after the first difference, for a wave to show.
inline constexpr std::size_t clocks_behind = 200;

/// The first clock that a wave of it shows, from 0, and the first that is compared.
std::uint64_t first_drawn(const Question& question, const Answer& answer);
std::size_t first_compared(const Question& question);

/// Finds the inputs that reset, once the gates of both are made, and puts them into the question;
/// where there is none `reset_clocks` becomes 0. Each input that resets a register asynchronously
/// is one. Without such an input it is the one that is called rst, reset, clr or clear and leaves
/// the most registers at constants; of several clocks it is each that leaves more of them so.
/// `wanted_resets` come in place of what would be found.
void find_resets(Question& question);

/// Whether there are several clocks in both together.
bool has_several_clocks(const Question& question);

/// Makes the gates of both sides, and compares them as far as the assumptions hold; a difference is
/// replayed in Verilator. InputError where the ports or the clocks do not agree, before anything
/// long; it lists them and says what to write. InputError where they would be equal but nothing
/// satisfies the assumptions.
Answer compare(Question& question);

}  // namespace cosim::equiv
