// The texts of a side: its files and those that they include.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tb/equiv/side.h"

namespace cosim::equiv {

struct SourceText {
  std::filesystem::path file;
  bool is_included = false;
  std::string text;
};

/// The files of a side in their order, then the files that they include, as far as the names of
/// these are found beside a file or in the folders of --include. Blanks stand in place of what is
/// behind `ifdef of a macro that no text, option or tool defines.
std::vector<SourceText> sources_of(const Files& files);

/// "FILE:LINE" of a place in a text.
std::string place_in(const SourceText& source, std::size_t at);

/// "FILE:LINE", the first place where the code of a text matches a regular expression of libc:
/// comments, strings and attributes do not count. Empty where none does.
std::string place_of(const std::vector<SourceText>& sources, const std::string& expression);

/// Whether it has variables of two values by way of an enumeration, a structure or a typedef. They
/// begin as 0, which neither yosys 0.23 nor Icarus Verilog 11 knows.
bool has_types_of_two_values(const std::vector<SourceText>& sources);

/// "FILE:LINE" of a module's port of a type of two values; "" where there is none. Such a port is
/// 0 where it is open or an index is beyond its end: x in Icarus Verilog, any value for yosys.
std::string place_of_two_valued_port(std::vector<SourceText> sources);

/// A name that no source has in it: `begins`, with as many underscores behind it as that takes.
std::string unused_name(std::string begins, const std::vector<SourceText>& sources);

}  // namespace cosim::equiv
