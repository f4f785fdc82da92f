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
  char letter = 0;   ///< 'A' .. 'Z'
  double value = 0;  ///< finite
  Place place;       ///< of the letter
};

/// Reads the text once, from front to end, in linear time. The rules:
///  - A line ends with LF, CR, CR LF or the end of the text. Each line with a word is a block.
///  - A word is a letter of either case and a decimal number without an exponent: `X10`, `x-.5`,
///    `G01`, `Y+1.`. Blanks and tabs mean nothing, even within a number: `x +0. 12` is `X0.12`.
///  - Comments: `( ... )` within a line, `;` to its end. In them any byte but NUL may stand.
///  - `%` at the start of a line before any word opens the program, with nothing but a comment
///    behind it; any other one ends it, and what follows the end is not read.
///  - A UTF-8 byte order mark at the head of the text is skipped.
/// Everything else is an InputError: block delete `/` (a switch of the machine would decide on the
/// path), parameters, expressions, checksums, other bytes, an unclosed comment, a letter without a
/// number, a number beyond the range of double.
class Lexer {
 public:
  /// `text` and `name` outlive the lexer; `name` stands in the errors.
  Lexer(std::string_view text, std::string_view name);

  Token next();

 private:
  bool at_end() const { return at_ >= text_.size(); }
  bool at_line_end() const { return at_end() || text_[at_] == '\n' || text_[at_] == '\r'; }
  Place here() const;
  void skip_blanks();
  void skip_comment();
  void skip_rest_of_line();
  Token end_line();
  Token word();
  double number(char letter, Place place);
  [[noreturn]] void refuse(char c) const;

  std::string_view text_;
  std::string_view name_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  std::uint32_t line_ = 1;
  bool line_blank_ = true;     ///< nothing but blanks so far on this line
  bool opening_line_ = false;  ///< behind the opening %
  bool opened_ = false;        ///< a word or a `%` has been read
  bool ended_ = false;         ///< the `%` that ends the program has been read
  std::string digits_;         ///< the number at hand without its blanks
};

}  // namespace cosim::toolpath
