// From a design's nets to the code of its lanes, and that as C++.
#pragma once

#include <string>
#include <vector>

#include "tb/lanes/layout.h"
#include "tb/lanes/straight.h"
#include "tb/nets/blif.h"
#include "tb/nets/played.h"
#include "tb/proof/rtl_nets.h"

namespace cosim::lanes {

/// What the code of a shape is made of. The memory is the same for all.
struct Code {
  Straight clock;  ///< draws the inputs, clocks and compares RTL and model
  Straight quiet;  ///< the same where `loud` gives no lane (quiet.h), if there is such a clock
  Straight loud;
  Straight stretch;    ///< before the first clock of a stretch: draws how often pins change
  Straight reset;      ///< one clock of the RTL alone, with the inputs that reset it
  Straight take_over;  ///< behind the last of them: what the model takes over from the RTL
  bool has_quiet = false;
  int reset_clocks = 0;
  bool is_asked = false;  ///< plane number 0 says in which lanes a job is over
  Layout layout;
};

/// InputError where the RTL is not what the model's tables say, or cannot run in lanes.
Code code_of(const nets::Played& played, const proof::RtlNets& rtl);

/// Nets as cells of at most three inputs, by abc: the outputs in their order from the inputs in
/// theirs. InputError, with `name`, where abc cannot be run.
nets::Cells mapped(const std::string& name, const nets::Graph& graph,
                   const std::vector<nets::Bit>& inputs, const std::vector<nets::Bit>& outputs);

/// As a source of C++ without anything of this project. It defines, for planes of V, words of
/// `lanes` bits, 64, 256 or 512,
///
///   int cosim_lanes                                      so many
///   char cosim_lanes_layout[]                            the layout of the memory, in words
///   void cosim_lanes_reset(V* m)                         resets the RTL
///   void cosim_lanes_take_over(V* m)                     gives the model what no reset reaches
///   void cosim_lanes_choose(V* m, const V* which, const V* from, uint64_t planes)
///                                                        takes over these lanes
///   void cosim_lanes_clear(V* m, const V* which, uint64_t planes)
///                                                        makes these lanes 0
///   int64_t cosim_lanes_run(V* m, const V* active, uint64_t from, uint64_t to, V* differ,
///                           uint64_t* left_out)
///
/// The last one runs clocks number from .. to - 1 of the cases. It ends after the first on which
/// any of the lanes at work differs, or its job is over, and returns its number and those that
/// differ; else -1.
std::string to_text(const Code& code, int lanes);

}  // namespace cosim::lanes
