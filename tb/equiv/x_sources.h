// Which x of the source a word of it may come from: a register, a memory or a net that it depends
// on, on this clock or any before. An x elsewhere excuses nothing.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/equiv/simulator.h"

namespace cosim::equiv {

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

 private:
  const std::set<int>& fan_in(const std::string& word);
  bool reaches(const std::string& from, const std::string& word);
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
  std::map<std::size_t, std::set<std::string>> drawn_;  ///< nets that are x, by clock
};

}  // namespace cosim::equiv
