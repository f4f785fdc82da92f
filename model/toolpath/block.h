// One block of a program: the words of a line, sorted by what they say.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "model/toolpath/codes.h"
#include "model/toolpath/lexer.h"

namespace cosim::toolpath {

/// Letters that move another axis than X and Y.
inline constexpr std::string_view other_axes = "ZABCUVW";
inline constexpr std::string_view axes = "XYZABCUVW";

class Block {
 public:
  bool empty = true;          ///< no word at all
  bool last_of_text = false;  ///< the program ended with it, by `%` or the end of the text
  bool stops = false;         ///< holds M2 or M30
  bool arguments = false;     ///< holds an M code whose words some controls take for arguments
  bool optional = false;      ///< block delete `/` opens it
  Place place;                ///< of its first word, or of the line's end

  /// Ten times the number of the block's G code of this group, -1 where there is none.
  int code(Group group) const { return codes_[static_cast<std::size_t>(group)]; }

  /// Where the block's G code of this group stands; void where there is none.
  Place place_of(Group group) const { return places_[static_cast<std::size_t>(group)]; }

  /// The word with this letter ('A' .. 'Z', not G or M); null where there is none.
  const Token* word(char letter) const {
    const auto i = static_cast<std::size_t>(letter - 'A');
    return (given_ >> i & 1) != 0 ? &words_[i] : nullptr;
  }

  /// The first in the line of the words with these letters; null where there is none.
  const Token* first_of(std::string_view letters) const;

  /// Takes in one more word. InputError for an unknown or unsupported one, a letter other than G
  /// and M given twice, a second G code of one modal group, and a word that a switch of the machine
  /// leaves out where it would matter.
  void add(const Token& word, std::string_view name);

  void clear();

 private:
  void add_g(const Token& word, std::string_view name);

  std::array<int, group_count> codes_{};
  std::array<Place, group_count> places_{};
  std::uint32_t given_ = 0;  ///< bit i: words_[i] is of this block
  std::array<Token, 26> words_{};
};

/// Reads the next block into `block`, in whose place the one before may stand; errors as add.
void read_block(Lexer& lexer, std::string_view name, Block& block);

}  // namespace cosim::toolpath
