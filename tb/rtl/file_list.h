// Lists of files, as simulators take them with -f and -F.
//
// Words are parted by blanks; one in quotation marks may have blanks. A comment is // or # up to
// the end of a line, or /* ... */, where a word may begin. $NAME, ${NAME} and $(NAME) are variables
// of the environment.
//
//   FILE                       Verilog, SystemVerilog or VHDL, in this order
//   -f LIST, -F LIST           another list, in its place
//   +incdir+DIR+DIR, -IDIR     folders of headers; one that is not there is left out
//   +define+NAME=VALUE+NAME, -DNAME=VALUE
//   -v FILE, -y DIR            modules that are taken where they are needed
//   --top-module NAME, -top NAME
//
// Paths begin at the working directory, in a list that is named with -F at its folder; in one that
// a list names with -f where those of that list do. Options that say how to read or what to warn of
// (-sv, +libext+.sv, -timescale=1ns/1ps, -Wall) are left out; any other one is an error.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cosim::rtl {

struct FileList {
  std::vector<std::string> files, libraries, include_dirs;  ///< paths; -v and -y are libraries
  std::vector<std::string> defines;                         ///< "NAME" or "NAME=VALUE"
  std::vector<std::string> lists;                           ///< itself, and those that it names
  std::string top;                                          ///< "": it names none
};

/// Where a path of a list is; none where it is not there.
using Place = std::function<std::optional<std::string>(const std::filesystem::path&)>;
/// There, or none.
std::optional<std::string> place_today(const std::filesystem::path& path);

/// Whether a name, behind --gold or in CMake, is that of a list: it ends in .f.
bool is_file_list(const std::filesystem::path& file);

/// Adds what `list` names to `all`; its paths begin at its folder if it `has_own_folder`. Each path
/// is looked up by `place`. InputError "LIST:LINE: ..." for what is not there or is not understood,
/// and for a list within itself.
void read_file_list(const std::filesystem::path& list, bool has_own_folder, const Place& place,
                    FileList& all);

/// The definitions of lists, and those of the command line: of one name the last one.
std::vector<std::string> with_defines(const std::vector<std::string>& listed,
                                      const std::vector<std::string>& typed);

}  // namespace cosim::rtl
