// A testbench of VHDL around an entity, which reads rows of inputs and writes rows of outputs.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "tb/equiv/vhdl_entity.h"
#include "tb/equiv/vhdl_run.h"

namespace cosim::equiv {

using VhdlLines = std::vector<std::string>;

/// Each port has lines of its own, so that a line that GHDL complains of tells which port it is.
struct VhdlTestbench {
  std::string text;
  std::map<std::size_t, std::string> port_of;  ///< by line
  std::string error;                           ///< why there is none

  void line(const std::string& one, const std::string& port = "");
};

/// The package that the testbench uses: between the types of ports and the digits of a row. GHDL
/// chooses the function by the type, so that nothing here reads types.
extern const char* const vhdl_conversions;

/// The characters of a row of the stimulus.
std::size_t vhdl_row_length(const VhdlStimulus& stimulus);

/// The entity cosim_tb, which reads FOLDER/in and writes FOLDER/out: rows of the stimulus as they
/// are run, and behind each the outputs.
VhdlTestbench vhdl_testbench(const VhdlEntity& entity, const VhdlStimulus& stimulus,
                             const std::string& folder);

}  // namespace cosim::equiv
