// A stimulus as a file that a person can read and change:
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
// reset. A # begins a comment.
//
// Of a design with a stream model a row is a transaction, and begins with that word
// (stream/shape.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tb/sim/bench.h"
#include "tb/sim/stimulus.h"

namespace cosim {

inline constexpr const char* first_line_of_stimulus = "cosim stimulus 1";

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
