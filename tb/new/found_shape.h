// The shape of RTL at some parameters.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/new/found.h"
#include "tb/rtl/run.h"
#include "tb/sim/progress.h"
#include "tb/util/process.h"

namespace cosim::cli {

/// InputError where there is none.
std::string verilator_program();
/// "-GNAME=VALUE"
std::string verilator_option(const FoundParameter& parameter);
/// As rtl::Run.
rtl::Ran run_for_rtl(const std::vector<std::string>& words);

/// The files as plain Verilog (rtl/plain_verilog.h), with parameters "NAME=VALUE"; `work`: a
/// folder.
std::vector<std::string> plain_verilog(const RtlQuestion& question,
                                       const std::vector<std::string>& parameters,
                                       const std::filesystem::path& work);

/// The shape with another value of a parameter; none where Verilator does not read it so, or not
/// soon. `verilator`: the program and its tree_options(); `work`: a folder for it alone.
std::optional<rtl::Shape> shape_with(const RtlQuestion& question, const std::string& other,
                                     long value, const std::vector<std::string>& verilator,
                                     const std::filesystem::path& work);

/// Tries other values of each parameter: sizes of `found` that follow one get their text, and
/// parameters that follow others are left out of it. `line` shows how many were tried.
void follow_parameters(Found& found, const rtl::Shape& shape, const RtlQuestion& question,
                       const std::filesystem::path& work, StateLine& line);

}  // namespace cosim::cli
