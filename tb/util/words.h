// Numbers and names as a person reads them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cosim {

/// "1 step", "2 steps"
std::string count(std::uint64_t n, const std::string& noun);

/// A number that need not be whole, rounded to three decimals: "0.369 steps", "1 step". It gets
/// more decimals if three would round it to a multiple of 1/2: "0.4996 steps".
std::string amount(double n, const std::string& noun);

/// The text on one line, as UTF-8: every byte outside of printable characters becomes "?".
std::string one_line(std::string text);

/// What a person typed, in quotes and on one line; cut where it is long.
std::string in_quotes(std::string_view text);

/// The words of a text, which blanks part.
std::vector<std::string> words_in(const std::string& text);
/// The parts of a text, which such characters end; the last one may go without.
std::vector<std::string> parts_in(std::string_view text, char end);
inline std::vector<std::string> lines_in(std::string_view text) { return parts_in(text, '\n'); }

/// Whether `text` is what `pattern` tells of, in which "*" stands for any text.
bool is_like(std::string_view text, std::string_view pattern);

/// How this program is called in what it says: "cosim", unless it was named otherwise.
const std::string& program_name();
/// How the user called it, "build/pwm_cosim", for command lines to copy; its name if that is not
/// known.
const std::string& program_call();
/// Names it; before any other thread runs.
void name_program(const std::string& name, const std::string& call = {});

/// "PROGRAM: TEXT" as one line on standard error. Throws nothing, even if standard error is closed
/// or full.
void complain(const std::string& text);

}  // namespace cosim
