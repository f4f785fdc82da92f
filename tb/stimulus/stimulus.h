// A stimulus: the inputs of every clock and where they start from, all that a run needs. It is kept
// as a file that a person can read and change:
//
//   cosim stimulus 1
//   machine NAME M=5 N=2
//   origin BP = 27, MP = 9
//   power-up 17
//   clock  initial_set_n  reset  write_bp  write_uk  start  data
//   0                  1      0         1         0      0    27
//   1                  1      0         0         1      0    10
//   2-9                1      0         0         0      0     0
//   end
//
// A row is one clock, or several equal ones. It has every input, in the form of the tables: bit
// strings in bits, above 16 bits in hexadecimal, all else as numbers. `state NAME=NUMBER ...`
// before the rows starts the run from that state of the model; fields without a NAME are as after a
// clear. A # begins a comment.
//
// Of a design with a stream model a row is a transaction, and begins with that word
// (stream/shape.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/core/fields.h"

namespace cosim {

class AnyBench;

struct Stimulus {
  std::string machine;         ///< AnyBench::title() of the bench it is for
  std::string origin;          ///< what it came from, one line; may be empty
  std::uint32_t power_up = 1;  ///< the RTL's registers at power-up
  /// The model's state to start from, in the order of its table; none: after a clear.
  std::optional<std::vector<Word>> state;
  std::vector<std::vector<Word>> clocks;  ///< the inputs of each clock, in the order of their table
};

/// The stimulus as a file. `bench` is the one it is for.
std::string to_text(const Stimulus& stimulus, const AnyBench& bench);

/// A stimulus and the bench it runs on.
struct Replay {
  const AnyBench* bench = nullptr;
  Stimulus stimulus;
};

/// The stimulus in `text`, for one of `benches`. InputError "NAME:LINE: ..." where it is none,
/// where it is not whole, and where it is for another machine.
Replay parse_stimulus(const std::string& name, const std::string& text,
                      const std::vector<std::unique_ptr<AnyBench>>& benches);

/// The same of a file; InputError where it cannot be read.
Replay read_stimulus(const std::string& path,
                     const std::vector<std::unique_ptr<AnyBench>>& benches);

}  // namespace cosim
