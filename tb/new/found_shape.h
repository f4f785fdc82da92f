// The shape of RTL at some parameters, as tb/dut/rtl_shape.pl tells it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/new/found.h"
#include "tb/support/process.h"
#include "tb/sweep/progress.h"

namespace cosim::cli {

struct FoundShape {
  std::string top;
  std::vector<std::pair<std::string, FoundNet>> ports;  ///< "input" or "output", and which
  std::vector<std::pair<std::string, long>> parameters;
  std::map<std::string, std::pair<int, int>> nets;  ///< width and words
};

/// Of the text of rtl_shape.pl.
FoundShape shape_of(std::string_view text);

/// Makes a folder with the programs that read RTL.
std::filesystem::path write_reader(const Scratch& scratch);

/// Has plain Verilog in place of the files, which are named as from `folder`: `made` in place of
/// those of VHDL, what GHDL makes of them with these parameters, "NAME=VALUE", and copies beside it
/// without the blackboxes and with inout ports split (rtl/plain_verilog.h). `reader`: that of
/// write_reader(). What is wrong, one line; "" where nothing is.
std::string as_plain_verilog(std::vector<std::string>& files, const std::string& top,
                             const std::vector<std::string>& parameters,
                             const std::vector<std::string>& blackboxes,
                             const std::filesystem::path& folder,
                             const std::filesystem::path& reader, const std::filesystem::path& made,
                             bool has_constants);

/// What reads RTL.
struct RtlReader {
  std::filesystem::path folder;  ///< that of write_reader()
  std::string verilator;         ///< the program
};

/// The shape with another value of a parameter; none where Verilator does not read it so. `work`: a
/// folder for it alone.
std::optional<FoundShape> shape_with(const RtlQuestion& question, const std::string& other,
                                     long value, const RtlReader& reader,
                                     const std::filesystem::path& work);

/// Tries other values of each parameter: sizes of `found` that follow one get their text, and
/// parameters that follow others are left out of it. `line` shows how many were tried.
void follow_parameters(Found& found, const FoundShape& shape, const RtlQuestion& question,
                       const RtlReader& reader, const std::filesystem::path& work, StateLine& line);

}  // namespace cosim::cli
