// G-code text into words: a letter and a number each, with blanks and comments gone.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "model/toolpath/source.h"

namespace cosim::toolpath {

struct Token {
  enum class Kind : std::uint8_t { word, end_of_block, end_of_program };
  Kind kind = Kind::end_of_program;
  char letter = 0;   ///< 'A' .. 'Z'; '/' where a block delete opens the line
  double value = 0;  ///< finite; 0 for '/'
  Place place;       ///< of the letter
};

/// Reads the text once, from front to end, in linear time. The rules:
///  - A line ends with LF, CR, CR LF or the end of the text. Each line with a word is a block.
///  - A word is a letter of either case and a decimal number without an exponent: `X10`, `x-.5`,
///    `G01`, `Y+1.`. Blanks and tabs mean nothing, even within a number: `x +0. 12` is `X0.12`.
///  - Comments: `( ... )` within a line, `;` to its end. In them any byte but NUL may stand.
///    One with a '(' in it and a second ')' behind it is an error: controls disagree on its end.
///  - `%` at the start of a line before any word opens the program, with nothing but a number and
///    a comment behind it; any other one ends it, and what follows the end is not read.
///  - A program number, `O1000` or `:1000`, may stand before the first word, alone on its line.
///  - Behind M0, M1, M117 and M118 a text that does not begin with a word and is free of `=`, `#`
///    and `[` is a message to the person at the machine, up to the line's end: `M117 Hello`, as
///    Marlin has it. A control without messages refuses such a line, so it can be no move.
///  - `/` at the start of a line, with or without a digit from 1 to 9, is a token of its own.
///  - A UTF-8 byte order mark at the head of the text is skipped.
/// Everything else is an InputError: parameters, expressions, checksums, subprograms, other bytes,
/// an unclosed comment, a letter without a number, a number beyond the range of double.
class Lexer {
 public:
  /// `text` and `name` outlive the lexer; `name` stands in the errors.
  Lexer(std::string_view text, std::string_view name);

  Token next();

  /// How many of the lines not read so far hold something: no blanks, `%` or comment alone.
  std::uint64_t lines_left() const;

 private:
  bool at_end() const { return at_ >= text_.size(); }
  bool at_line_end() const { return at_end() || text_[at_] == '\n' || text_[at_] == '\r'; }
  Place here() const;
  void skip_blanks();
  void skip_comment();
  void skip_rest_of_line();
  Token end_line();
  Token word();
  Token block_delete();
  void program_number();
  bool at_message() const;
  double number(char letter, Place place);
  [[noreturn]] void refuse(char c) const;

  std::string_view text_;
  std::string_view name_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
  bool line_blank_ = true;  ///< nothing but blanks so far on this line
  std::string_view alone_;  ///< what has been read on this line and stands alone there
  bool opened_ = false;     ///< a word, a program number or a `%` has been read
  bool begun_ = false;      ///< a word or a program number has been read
  bool ended_ = false;      ///< the `%` that ends the program has been read
  std::string digits_;      ///< the number at hand without its blanks
};

}  // namespace cosim::toolpath
