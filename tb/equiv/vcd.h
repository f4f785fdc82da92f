// A VCD file as Verilator writes it, read forward in time: what its signals are as a simulation's
// are read.
#pragma once

#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tb/dut/signal.h"

namespace cosim::equiv {

class Vcd {
 public:
  /// Takes the signals of the scopes below `from`, the name of a scope, as those of `name`. Logic
  /// of two values: what is x or z counts as 0. Reals are left out.
  Vcd(const std::string& text, const std::string& from, const std::string& name);
  Vcd(const Vcd&) = delete;
  Vcd& operator=(const Vcd&) = delete;

  /// Their bytes are valid as long as this object lives.
  const std::vector<Signal>& signals() const { return signals_; }
  /// All changes before the time `ps`, in picoseconds; no earlier than that of the last call.
  void go_to(std::uint64_t ps);

 private:
  struct Value {
    int width = 1;
    std::vector<unsigned char> bytes;  ///< the lowest first
  };
  void header(const std::string& from, const std::string& name);
  void change(const std::string& word);

  std::istringstream in_;
  std::map<std::string, Value> values_;  ///< by the file's code
  std::vector<Signal> signals_;
  std::uint64_t tick_ = 1;  ///< picoseconds
  std::uint64_t now_ = 0;   ///< of the changes that come next, in picoseconds
};

}  // namespace cosim::equiv
