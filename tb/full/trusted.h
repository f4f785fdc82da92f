// Whether the gates that proofs, lanes and mutants rest on are what the RTL says.
#pragma once

#include <string>

#include "tb/nets/model.h"
#include "tb/proof/yosys.h"
#include "tb/sim/bench.h"

namespace cosim::cli {

/// How RTL was read.
struct ReadAs {
  /// "read by yosys, as Icarus Verilog simulates it on 2048 clocks"; empty where it is not so.
  std::string by;
  /// What differs, on which clock, both values; or, where nothing could be compared, why.
  std::string why;
  bool is_wrong = false;  ///< something differs, or every front end refuses the RTL

  /// What is said of it then.
  std::string wrong() const {
    return (why.starts_with("the RTL: ") ? "" : "the RTL is misread: ") + why;
  }
};

/// Runs the cells that a front end of `equiv` reads beside the RTL in a simulator
/// (equiv/referee.h), and the gates of `source` beside those cells, from random states under random
/// inputs. What came of it is kept in the build folder by the hash of the RTL's files. `source` as
/// for claims on `model` (source_for()). InputError where it cannot be read.
ReadAs read_as(const nets::Model& model, const proof::Source& source);

/// InputError "TOP: the RTL is misread: WHY" where something differs.
void require_read(const nets::Model& model, const proof::Source& source);

}  // namespace cosim::cli
