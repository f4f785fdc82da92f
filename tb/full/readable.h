// RTL as the program can read it: by yosys, or by slang where yosys cannot.
#pragma once

#include <string>

#include "tb/equiv/side.h"
#include "tb/proof/yosys.h"

namespace cosim::cli {

/// The RTL as equiv is given it.
equiv::Files files_of(const proof::Source& source);

/// Of the files, of what may be included in them, and of how they are read.
std::string hash_of_rtl(const proof::Source& source);

/// The same RTL, of SystemVerilog that yosys cannot read with what slang writes of it, which is
/// kept in the build folder. InputError where neither reads it, and where slang is not installed.
proof::Source readable(proof::Source source);

}  // namespace cosim::cli
