// One careless run of the program: its whole command line, its streams and the moment a signal
// comes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/careless/commands.h"
#include "tests/support/child.h"

namespace cosim::careless {

using test::Stream;

struct Case {
  std::vector<std::string> arguments;
  Stream in = Stream::file, out = Stream::file, err = Stream::file;
  int signal = 0;         ///< 0: none, but for SIGTERM at the end of its time
  int after = 0;          ///< milliseconds until it comes
  long largest_file = 0;  ///< bytes that a file may have; 0 as the run sets it
  /// What an option or a positional names, by the option's name: the files that it may write.
  struct Named {
    std::string option, value;
  };
  std::vector<Named> named;
};

/// The case of this number. Its files lie in the folders of scratch.h.
Case draw(const std::vector<Command>& commands, std::uint64_t seed, std::uint64_t number);

/// As a shell would take it.
std::string command_line(const std::string& program, const Case& one);

}  // namespace cosim::careless
