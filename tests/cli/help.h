// What the program says of its commands, read back.
#pragma once

#include <string>
#include <vector>

#include "tests/cli/program.h"

namespace cosim::cli {

/// The help of a command, or of the program where there is none.
std::string help(Arguments command);

/// Each of the words is in the text.
void expect_in(const std::string& text, const std::vector<std::string>& words);

/// Every command that has no commands of its own, as the help of those above it names them.
std::vector<Arguments> commands(const Arguments& above = {});

/// Their names, one behind the other: "list, line, arc".
std::string names_of_commands(const Arguments& above = {});

/// The commands whose help has that text, an option.
std::vector<Arguments> commands_with(const std::string& option);

/// "sweep linear"
std::string name_of(const Arguments& command);

/// The words of the command's example, with a G-code program and a stimulus of the project's in the
/// place of its own, and what it writes in the folder.
Arguments example_of(const Arguments& command, const Folder& folder);

}  // namespace cosim::cli
