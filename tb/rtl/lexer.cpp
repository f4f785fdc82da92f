#include "tb/rtl/lexer.h"

#include <algorithm>
#include <cctype>

#include "tb/rtl/regex.h"

namespace cosim::rtl {
namespace {

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}

}  // namespace

std::string_view Lexer::next() {
  skip();
  const std::size_t from = at_;
  if (at_ == text_.size()) return {};
  if (text_[at_] == '"') {
    for (++at_; at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n'; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    at_ = std::min(at_ + 1, text_.size());
  } else if (is_of_word(text_[at_]) || text_[at_] == '`') {
    ++at_;
    while (at_ < text_.size() && is_of_word(text_[at_])) ++at_;
  } else {
    at_ += text_.substr(at_, 2) == "::" ? 2 : 1;
  }
  return text_.substr(from, at_ - from);
}

void Lexer::skip() {
  // Behind an end that there may be none of.
  const auto behind = [&](std::string_view end) {
    const std::size_t at = text_.find(end, at_ + 2);
    return at == std::string_view::npos ? text_.size() : at + end.size();
  };
  while (at_ < text_.size()) {
    const std::string_view two = text_.substr(at_, 2);
    if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
      ++at_;
    } else if (two == "//") {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (two == "/*") {
      at_ = behind("*/");
    } else if (two == "(*" && text_.substr(at_, 3) != "(*)" &&
               text_.find("*)", at_ + 2) != std::string_view::npos) {
      at_ = behind("*)");
    } else {
      return;
    }
  }
}

std::string code_of(std::string_view text) {
  std::string plain(text);
  for (char& c : plain) c = c == '\n' ? c : ' ';
  Lexer lexer(text);
  for (std::string_view word = lexer.next(); !word.empty(); word = lexer.next()) {
    const auto at = static_cast<std::size_t>(word.data() - text.data());
    if (word.front() != '"') plain.replace(at, word.size(), word);
  }
  // A macro goes on in the next line.
  for (std::size_t at = plain.find("\\\n"); at != plain.npos; at = plain.find("\\\n", at)) {
    plain[at] = ' ';
  }
  return plain;
}

std::string blanked(std::string_view text) {
  const std::string plain = code_of(text);
  static const Regex directive(
      "(^|\n)[ \t]*`(ifn?def|els\\w+|endif|define|undef|include|timescale|default_nettype|"
      "resetall)[^\n]*");
  return directive.replaced(plain, [](const Match& line) {
    return line[1] + std::string(line.size() - line.size(1), ' ');
  });
}

}  // namespace cosim::rtl
