// The words and signs of Verilog.
#pragma once

#include <string>
#include <string_view>

namespace cosim::rtl {

/// Reads a text without its comments and its attributes, `(* keep *)`. The text of a string is one
/// word, with its quotation marks.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}
  /// The next word, a part of the text; empty at the end.
  std::string_view next();

 private:
  void skip();

  std::string_view text_;
  std::size_t at_ = 0;
};

/// The text with blanks in place of its comments, attributes and strings, and of what joins two
/// lines: places and lines stay.
std::string code_of(std::string_view text);
/// The same without the directives that have a line of their own but use no macro.
std::string blanked(std::string_view text);

}  // namespace cosim::rtl
