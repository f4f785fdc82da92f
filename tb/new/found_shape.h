// The shape of RTL at some parameters, as tb/dut/rtl_shape.pl tells it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/new/found.h"
#include "tb/sweep/progress.h"
#include "tb/util/process.h"

namespace cosim::cli {

struct FoundShape {
  struct Net {
    int width = 0, words = 0;  ///< words as of FoundNet
    bool is_signed = false;
    std::vector<FoundPart> parts = {};
    bool operator==(const Net&) const = default;
  };
  std::string top;
  std::vector<std::pair<std::string, std::string>> ports;  ///< "input" or "output", and its name
  std::vector<std::pair<std::string, long>> parameters;
  std::map<std::string, Net> nets;
  std::map<std::string, std::vector<std::string>> enums = {};  ///< as of Found
};

/// Of the text of rtl_shape.pl.
FoundShape shape_of(std::string_view text);

/// Makes a folder with the programs that read RTL.
std::filesystem::path write_reader(const Scratch& scratch);

/// The files as plain Verilog (rtl/plain_verilog.h), with parameters "NAME=VALUE"; `work`: a
/// folder.
std::vector<std::string> plain_verilog(const RtlQuestion& question,
                                       const std::vector<std::string>& parameters,
                                       const std::filesystem::path& work);

/// What reads RTL.
struct RtlReader {
  std::filesystem::path folder;        ///< that of write_reader()
  std::vector<std::string> verilator;  ///< the program, and the options before the file of its tree
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
