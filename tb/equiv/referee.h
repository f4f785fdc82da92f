// Whether a netlist is what its source says: both run side by side, the source in a simulator that
// read it by itself. No verdict rests on what one reader alone says.
//
// Registers without an initial value are given one in both, so that an x is one of the source. The
// netlist runs 64 times at once, with other values for what is not known in each. Where the source
// is 0 or 1, all of them must say so; where the source of the new RTL is x though its registers are
// known, they must not all say the same, for such an x would be taken for what is convenient.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/equiv/side.h"
#include "tb/equiv/simulator.h"
#include "tb/util/random.h"

namespace cosim::equiv {

struct Refereed {
  bool agrees = false;
  std::string by;  ///< "Icarus Verilog"; empty where no simulator has run it
  int clocks = 0;  ///< that were compared
  std::string
      wrong;  ///< one line: what differs, on which clock, both values; or why it did not run
};

struct Referee {
  bool steps = false;                  ///< clocks are inputs
  std::map<std::string, bool> resets;  ///< inputs that reset, and the level
  bool x_matters = false;              ///< it is the new RTL
  bool verilator = true;               ///< may be used, where Icarus cannot read the source
  std::chrono::steady_clock::time_point until;
};

/// Compares the gates of a side, which were made, with its source: outputs and registers.
Refereed refereed(const Side& side, const Referee& how);
/// The same of a side that was made of VHDL, in GHDL, which runs that: the outputs.
Refereed refereed_vhdl(const Side& side, const Referee& how);

/// Inputs by chance, in stretches of some clocks that each have their own ways: mostly low or
/// mostly high bits, small numbers, ends of ranges, what was before, the same word as another
/// input, and what the netlist compares inputs with: the cases of a decoder.
class RefereeInputs {
 public:
  using Row = std::map<std::string, std::string>;  ///< digits of each input, the highest first

  RefereeInputs(const Side& side, const Referee& how);

  /// Of one clock; they are asked for in order, from 0. Resets are active on the first three, and
  /// on one in 60 by chance.
  Row row(std::size_t clock);

 private:
  /// Bits of ports, and the digit of each.
  using Compared = std::vector<std::pair<Name, char>>;
  void find_compared();
  void find_written();
  std::string digits(const std::string& port, std::size_t width, const Row& row);

  const Side& side_;
  const Referee& how_;
  Random random_;
  std::vector<Compared> compared_;
  std::map<std::string, std::uint64_t> ways_;
  Row before_;
};

/// The clocks on which source and netlist run, and each row of them by its ports, behind `rows`.
/// `gates`: of the netlist, of which more take fewer clocks.
Stimulus referee_stimulus(const Side& side, const Referee& how, Simulator simulator,
                          std::size_t gates, std::vector<RefereeInputs::Row>& rows);

/// Values of inputs and registers that make a gate of the netlist what it hardly is by chance; the
/// others are free.
struct RarePattern {
  std::vector<std::pair<Name, char>> inputs;  ///< bits of ports
  std::map<std::size_t, char> state;          ///< by register
};

/// Test patterns: a solver finds them for gates that are 0, or 1, on hardly any of these clocks, so
/// that what stands behind a comparison of 32 bits is compared as well.
std::vector<RarePattern> rare_patterns(const Side& side, const Referee& how,
                                       const std::vector<RefereeInputs::Row>& rows);

/// States to load into the variables of a stimulus behind its last clock, so that what is behind a
/// rare state, as behind a counter at 5,000, is compared as well. The values: what the netlist
/// compares words with, small numbers, chance, so many `times`; and those of the patterns, once.
/// Nothing where a state that is never reached may be read in another way: as where cases are said
/// to exclude each other, and where a register resets another one.
void load_states(const Side& side, std::size_t times, const std::vector<RarePattern>& patterns,
                 Stimulus& stimulus);

/// Whether a register that begins as 0 for its type's sake is x in the simulator, unless it is
/// given a value there.
bool may_be_x(const Side& side, Simulator simulator);

/// Which x of the source a word of it may come from: a register, a memory or a net that it depends
/// on, on this clock or any before. An x elsewhere excuses nothing.
class XSources {
 public:
  /// `shown`: the stimulus of which registers and memories the simulator has given a value. All
  /// must outlive it.
  XSources(const Side& side, const Stimulus& shown, Simulator simulator,
           std::chrono::steady_clock::time_point until);

  /// Whether it may be that a register or a memory begins as x and is not shown.
  bool has_hidden() const { return !hidden_.empty(); }
  /// The shown registers that are x on the next clock.
  void clock(std::set<std::string> registers);
  /// Whether a register or a memory is x that a port or a register depends on, or may be, on this
  /// clock or the one before.
  bool reach(const std::string& word);
  /// Whether a net is x or z that it depends on, on clock t or the one before. Runs the simulator.
  bool net_reaches(const std::string& word, std::size_t t);
  /// The same of nets that are z.
  bool z_reaches(const std::string& word, std::size_t t);

 private:
  const std::set<int>& fan_in(const std::string& word);
  bool reaches(const std::string& from, const std::string& word);
  using Drawn = std::map<std::size_t, std::set<std::string>>;  ///< nets, by clock
  bool reaches(const Drawn& drawn, const std::string& word, std::size_t t);
  void draw(std::size_t from);

  const Side& side_;
  const Stimulus& shown_;
  Simulator simulator_;
  std::chrono::steady_clock::time_point until_;
  std::map<std::string, const std::vector<int>*> bits_;  ///< of ports and nets
  std::map<int, const Cell*> driver_;
  std::map<std::string, std::set<int>> fan_in_;  ///< of those that were asked for
  std::set<int> hidden_;                         ///< nets of what begins as x and is not shown
  std::set<std::string> now_, before_;           ///< registers that are x
  Drawn x_, z_;                                  ///< nets that are x or z, and those that are z
};

}  // namespace cosim::equiv
