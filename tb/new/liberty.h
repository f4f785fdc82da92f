// The cells of a Liberty file in Verilog.
#pragma once

#include <map>
#include <string>

namespace cosim::cli {

/// By its name, *.lib.
bool is_liberty(const std::string& file);

struct LibertyCells {
  std::string verilog;                          ///< a module a cell
  std::map<std::string, std::string> left_out;  ///< cells of which none can be made, and why
};

/// `text` is that of `file`. InputError "FILE:LINE: ...".
LibertyCells cells_of(const std::string& text, const std::string& file);

}  // namespace cosim::cli
