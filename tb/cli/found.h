// What yosys finds in RTL that somebody brings: its ports, parameters and registers.
#pragma once

#include <string>
#include <vector>

namespace cosim::cli {

/// A number with the parameters' defaults.
struct FoundSize {
  int number = 1;
  /// The parameter that it follows, and what is to be added to it; empty where it follows none.
  std::string parameter = {};
  int more = 0;
};

/// A port, a register or a memory.
struct FoundNet {
  std::string name;              ///< of a register its path below the top
  FoundSize width;               ///< bits, of a memory those of a word
  FoundSize words = {0, {}, 0};  ///< of a memory; 0: none
  bool is_reset = true;          ///< false of a memory that is only written at an address
};

struct FoundParameter {
  std::string name;
  int value = 0;  ///< its default
};

struct Found {
  std::string top;
  std::string clock;
  std::string reset;  ///< the input that is thought to be it, by its name; empty where none is
  bool active_low = false;
  bool asynchronous = false;  ///< that input resets registers without waiting for the clock
  std::vector<FoundNet> inputs, outputs, registers;  ///< inputs without the clock
  std::vector<FoundParameter> parameters;            ///< those that are whole numbers
};

/// Reads the files. InputError, one line, where yosys cannot, where there is no clock or a second
/// one, and for what a design cannot have: a latch, a bidirectional port, a register without a
/// name. Without `registers` none are looked for.
Found found_in(const std::vector<std::string>& files, bool registers = true);

}  // namespace cosim::cli
