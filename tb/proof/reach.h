// Can this ever happen, from reset? Asked of yosys-abc, whose engines run side by side.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "tb/nets/graph.h"

namespace cosim::proof {

enum class Ever {
  never,  ///< proved for every clock
  yes,    ///< it does, and `inputs` make it so
  open,   ///< not in the first `clocks` clocks; nothing is known of later ones
};

struct Reached {
  Ever ever = Ever::open;
  std::string by;  ///< the engines that decided: "scorr and pdr"; "dsat; iprove": either by itself
  std::vector<std::vector<bool>> inputs;  ///< of yes: a row a clock; `bad` is 1 on the last one
  bool least = false;                     ///< of yes: no shorter stimulus does it
  int clocks = 0;                         ///< of open
  int engines = 0;                        ///< of never: how many of abc's said so by themselves
};

/// Whether `bad` is ever 1, where the registers begin as the graph says and the inputs are any. A
/// stimulus has been tried on the graph, so that yes holds whatever the engine says. Ends when it
/// is `until`, with `jobs` engines at a time. InputError where there is no yosys-abc.
Reached reach(const nets::Graph& graph, nets::Bit bad, std::chrono::steady_clock::time_point until,
              unsigned jobs = 4);

}  // namespace cosim::proof
