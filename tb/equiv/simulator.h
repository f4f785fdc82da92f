// The source of a side, run in a simulator that reads it by itself.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tb/equiv/testbench.h"

namespace cosim::equiv {

enum class Simulator {
  icarus,     ///< four values: 0, 1, x and z
  verilator,  ///< two values; its compiler takes ten seconds or more
  ghdl,       ///< of VHDL (vhdl_run.h)
};
const char* name_of(Simulator simulator);

/// What it does.
struct Simulated {
  std::vector<std::vector<std::string>> clocks;  ///< the words of each clock, in their order
  std::map<std::string, std::string> before;     ///< variables before they were given a value
  std::map<std::string, std::string> after;
  std::map<std::string, std::vector<std::string>> memories;
  bool is_complete = false;  ///< it came to the last clock
  std::string why{};         ///< where it did not, what it said of that; empty where nothing
};

class Program {
 public:
  /// Builds the source with a testbench for the stimulus. Variables and memories that the simulator
  /// does not know by their names are left out of it. OutOfTime.
  Program(const Side& side, Stimulus stimulus, Simulator simulator,
          std::chrono::steady_clock::time_point until);

  /// Why it is not built, one line; empty where it is.
  const std::string& why_not() const { return why_not_; }
  /// The variables that are printed.
  const Stimulus& stimulus() const { return stimulus_; }
  /// Runs it, to its end or until it is that late. What has no value begins in Verilator as
  /// `begins` says, "0", "1" or by chance as "2".
  Simulated run(std::chrono::steady_clock::time_point until, const char* begins = "0") const;
  /// What the last run wrote of its wave.
  std::string wave() const;

 private:
  std::vector<std::string> command(const std::string& generation) const;
  Ended build(const std::string& generation, std::chrono::steady_clock::time_point until) const;
  std::vector<std::string> sources(const char* define, const char* folder) const;
  void find_arrays(std::chrono::steady_clock::time_point until);
  void copy_simpler();
  std::string by_own_names(std::string text) const;
  bool leave_out(const std::string& said, std::map<std::size_t, std::string> line_of);

  const Side& side_;
  Stimulus stimulus_;
  Simulator simulator_;
  Scratch scratch_;
  std::string own_, bench_, why_not_;          ///< bench_: the testbench's module
  std::map<std::string, std::string> copies_;  ///< by files: those that are read in their place
};

}  // namespace cosim::equiv
