#include "model/toolpath/block.h"

#include <string>

namespace cosim::toolpath {

namespace {

// Words that the reader uses or that leave the path alone: feed, speed, tool, line number, and the
// arguments of G4, G10, G43, G64, G96 and G187.
constexpr std::string_view known_letters = "ABCDEFHIJKLNPQRSTUVWXYZ";

// What may stand behind a block delete, for the path is the same with it and without it.
constexpr std::string_view optional_letters = "MSTFNHD";

}  // namespace

const Token* Block::first_of(std::string_view letters) const {
  const Token* first = nullptr;
  for (const char letter : letters) {
    const Token* found = word(letter);
    if (found && (first == nullptr || found->place.column < first->place.column)) first = found;
  }
  return first;
}

void Block::add(const Token& word, std::string_view name) {
  if (word.letter == '/') {
    optional = true;
    return;
  }
  empty = false;
  if (optional && (optional_letters.find(word.letter) == std::string_view::npos ||
                   (word.letter == 'M' && ends_program(word.value)))) {
    fail(name, word.place, "block delete '/' is not supported here: a switch would set the path");
  }
  if (word.letter == 'G') return add_g(word, name);
  if (word.letter == 'M') {
    std::string why;
    if (!accept_m_code(word.value, why)) fail(name, word.place, why);
    stops |= ends_program(word.value);
    arguments |= takes_arguments(word.value);
    return;
  }
  const std::string letter(1, word.letter);
  if (known_letters.find(word.letter) == std::string_view::npos) {
    fail(name, word.place, "unknown word " + letter);
  }
  const auto i = static_cast<std::size_t>(word.letter - 'A');
  if ((given_ >> i & 1) != 0) fail(name, word.place, letter + " is given twice in the block");
  given_ |= std::uint32_t{1} << i;
  words_[i] = word;
}

void Block::add_g(const Token& word, std::string_view name) {
  GCode code;
  std::string why;
  if (!find_g_code(word.value, code, why)) fail(name, word.place, why);
  if (code.group == Group::cancel) return;
  const auto group = static_cast<std::size_t>(code.group);
  if (codes_[group] >= 0) fail(name, word.place, "a second G code of one modal group in the block");
  codes_[group] = code.tenths;
  places_[group] = word.place;
}

// Words that are not given are left as they are: a block of one word stays cheap.
void Block::clear() {
  empty = true;
  last_of_text = false;
  stops = arguments = optional = false;
  codes_.fill(-1);
  given_ = 0;
}

void read_block(Lexer& lexer, std::string_view name, Block& block) {
  block.clear();
  for (;;) {
    const Token token = lexer.next();
    if (block.empty) block.place = token.place;
    if (token.kind != Token::Kind::word) {
      block.last_of_text = token.kind == Token::Kind::end_of_program;
      return;
    }
    block.add(token, name);
  }
}

}  // namespace cosim::toolpath
