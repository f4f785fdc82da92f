#include "model/toolpath/lexer.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <optional>
#include <system_error>

namespace cosim::toolpath {

namespace {

// Not <cctype>: its answers depend on the locale, and it has no answer for negative chars.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte > 0x20 && byte < 0x7f) return std::string("'") + c + "'";
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "byte 0x%02x", byte);
  return text.data();
}

}  // namespace

Lexer::Lexer(std::string_view text, std::string_view name) : text_(text), name_(name) {
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

Place Lexer::here() const { return {line_, static_cast<std::uint32_t>(at_ - line_start_ + 1)}; }

Token Lexer::next() {
  for (;;) {
    skip_blanks();
    if (ended_ || at_end()) return {Token::Kind::end_of_program, 0, 0, here()};
    if (at_line_end()) return end_line();
    const char c = text_[at_];
    if (c == '%' && line_blank_) {
      ended_ = opened_;
      opened_ = true;
      alone_ = "the '%' that opens the program";
      ++at_;
      while (!ended_ && !at_end() && is_digit(text_[at_])) ++at_;
    } else if (c == '(') {
      skip_comment();
    } else if (c == ';') {
      skip_rest_of_line();
    } else if (!alone_.empty()) {
      fail(name_, here(), std::string(alone_) + " stands alone on its line");
    } else if (c == ':' || c == 'O' || c == 'o') {
      program_number();
    } else if (c == '/' && line_blank_) {
      return block_delete();
    } else if (is_upper(c) || is_lower(c)) {
      return word();
    } else {
      refuse(c);
    }
    line_blank_ = false;
  }
}

void Lexer::skip_blanks() {
  while (!at_end() && is_blank(text_[at_])) ++at_;
}

void Lexer::skip_comment() {
  const Place opened = here();
  std::optional<Place> inner;
  for (++at_; !at_line_end() && text_[at_] != ')'; ++at_) {
    if (text_[at_] == '\0') refuse('\0');
    if (text_[at_] == '(' && !inner) inner = here();
  }
  if (at_line_end()) fail(name_, opened, "the comment is not closed on its line: ')' missing");
  ++at_;
  if (!inner) return;
  const std::size_t next = text_.find_first_of("();\r\n", at_);
  if (next != text_.npos && text_[next] == ')') {
    fail(name_, *inner, "a comment within a comment: controls disagree on where it ends");
  }
}

void Lexer::skip_rest_of_line() {
  while (!at_line_end()) {
    if (text_[at_] == '\0') refuse('\0');
    ++at_;
  }
}

Token Lexer::end_line() {
  const Token token{Token::Kind::end_of_block, 0, 0, here()};
  at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
  line_start_ = at_;
  ++line_;
  line_blank_ = true;
  alone_ = {};
  return token;
}

Token Lexer::word() {
  const Place place = here();
  const char c = text_[at_++];
  const char letter = is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c;
  line_blank_ = false;
  opened_ = begun_ = true;
  const double value = number(letter, place);
  if (letter == 'M' && (value == 0 || value == 1 || value == 117 || value == 118) && at_message()) {
    skip_rest_of_line();
  }
  return {Token::Kind::word, letter, value, place};
}

// A letter that no number follows, or a letter of another alphabet: nothing that a control which
// has no messages would take for a word, `X=5` and `CR=5` of Siemens' included.
bool Lexer::at_message() const {
  if (at_line_end()) return false;
  const char first = text_[at_];
  const bool foreign = static_cast<unsigned char>(first) >= 0x80;
  if (!foreign && !is_upper(first) && !is_lower(first)) return false;
  const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
  const std::string_view rest = text_.substr(at_, end - at_);
  if (rest.find_first_of("=#[") != rest.npos) return false;
  const std::size_t next = rest.find_first_not_of(" \t", 1);
  return foreign || next == rest.npos ||
         std::string_view("0123456789+-.(").find(rest[next]) == std::string_view::npos;
}

Token Lexer::block_delete() {
  const Token token{Token::Kind::word, '/', 0, here()};
  ++at_;
  if (!at_end() && text_[at_] >= '1' && text_[at_] <= '9') ++at_;
  line_blank_ = false;
  opened_ = begun_ = true;
  return token;
}

void Lexer::program_number() {
  const Place place = here();
  const bool colon = text_[at_] == ':';
  const std::size_t digits = ++at_;
  while (!at_end() && is_digit(text_[at_])) ++at_;
  const bool numbered = at_ > digits;
  skip_blanks();
  const bool alone = at_line_end() || text_[at_] == '(' || text_[at_] == ';';
  if (!colon && !(numbered && alone)) {
    fail(name_, place, "O-words (subprograms and flow control) are not supported");
  }
  if (!numbered) fail(name_, place, "a program number needs digits");
  if (begun_) fail(name_, place, "a program number stands before the first word");
  alone_ = "the program number";
  opened_ = begun_ = true;
}

std::uint64_t Lexer::lines_left() const {
  std::uint64_t count = 0;
  for (std::string_view rest = text_.substr(at_); !rest.empty();) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == line.npos || line[first] == ';') continue;
    line = line.substr(first, line.find_last_not_of(" \t") + 1 - first);
    const bool comment = line[0] == '(' && line.find(')') == line.size() - 1;
    count += !comment && line != "%" ? 1 : 0;
  }
  return count;
}

double Lexer::number(char letter, Place place) {
  digits_.clear();
  bool any_digit = false;
  bool any_point = false;
  for (skip_blanks(); !at_end(); skip_blanks()) {
    const char c = text_[at_];
    const bool sign = (c == '+' || c == '-') && digits_.empty();
    const bool point = c == '.' && !any_point;
    if (!sign && !point && !is_digit(c)) break;
    any_digit |= is_digit(c);
    any_point |= point;
    digits_ += c;
    ++at_;
  }
  if (!any_digit) {
    if (!at_end() && (text_[at_] == '#' || text_[at_] == '[')) refuse(text_[at_]);
    fail(name_, place, std::string(1, letter) + " needs a number");
  }
  std::string_view digits = digits_;
  if (digits.front() == '+') digits.remove_prefix(1);  // from_chars does not take it
  double value = 0;
  const char* const begin = digits.data();
  const char* const end = begin + digits.size();
  if (std::from_chars(begin, end, value, std::chars_format::fixed).ec != std::errc()) {
    fail(name_, place, std::string("the number of ") + letter + " is out of range");
  }
  return value;
}

void Lexer::refuse(char c) const {
  switch (c) {
    case '\0':
      fail(name_, here(), "NUL byte: this is not a text file");
    case '/':
      fail(name_, here(), "block delete '/' stands at the start of a line");
    case '#':
      fail(name_, here(), "parameters ('#') are not supported");
    case '[':
      fail(name_, here(), "expressions ('[') are not supported");
    case '*':
      fail(name_, here(), "checksums and expressions ('*') are not supported");
    case ')':
      fail(name_, here(), "')' without '('");
    default:
      fail(name_, here(), "unexpected " + shown(c));
  }
}

}  // namespace cosim::toolpath
