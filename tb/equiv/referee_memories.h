// The memories of a side, in the source and in the netlist.
#pragma once

#include <map>
#include <string>

#include "tb/equiv/simulator.h"
#include "tb/equiv/stepped.h"

namespace cosim::equiv {

inline bool is_known(char digit) { return digit == '0' || digit == '1'; }

class RefereeMemories {
 public:
  explicit RefereeMemories(const Side& side) : side_(side) {}

  /// Has the simulator give a value to words that have no initial one.
  void add_to(Stimulus& s);
  /// The netlist begins with the words of the source. What is wrong where these are not what the
  /// netlist says, else "".
  std::string begin(const Contents& one, const Simulated& ran, Stepped& stepped) const;

 private:
  const Side& side_;
  Scratch files_;
  std::map<std::string, std::string> contents_;
  std::map<std::string, std::size_t> number_of_;
};

}  // namespace cosim::equiv
