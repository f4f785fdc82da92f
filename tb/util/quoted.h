// Names in the texts that other programs read: one function for each kind of text. A name that no
// quoting holds is an InputError, so that none is ever read as a command.
#pragma once

#include <filesystem>
#include <string>

namespace cosim {

/// A file that a command of yosys reads. InputError for a name with a quotation mark or a control
/// character.
std::string file_for_yosys(const std::filesystem::path& file);

/// A word of a command of yosys that it takes no quotation for: a top module, a parameter, a
/// definition, a folder. InputError for one with a blank, a quotation mark, a semicolon, a control
/// character or a number sign in front.
std::string word_for_yosys(const std::string& word);

/// An argument of a command of CMake; not in quotation marks where it needs none. InputError for
/// one with a semicolon, which makes a list of it, or a control character.
std::string for_cmake(const std::string& text);

/// A word of a command of a shell; not in quotation marks where it needs none.
std::string for_shell(const std::string& text);

/// A string of gnuplot. InputError for one with a control character.
std::string for_gnuplot(const std::string& text);

}  // namespace cosim
