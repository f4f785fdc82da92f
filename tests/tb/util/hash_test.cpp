// The one hash: that of the literature, of a text and of a file alike.
#include "tb/util/hash.h"

#include <gtest/gtest.h>

#include <string>

#include "model/core/input_error.h"
#include "tests/support/folder.h"

namespace cosim {
namespace {

// As xxhsum -H2 has it of an empty file: other programs find the same.
TEST(Hash, IsThatOfTheLiterature) { EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f"); }

TEST(Hash, OfAFileIsThatOfItsText) {
  const test::Folder folder;
  for (const std::size_t size : {0U, 1U, (1U << 20) - 1, 1U << 20, (3U << 20) + 5}) {
    std::string text(size, 'x');
    for (std::size_t i = 0; i < size; i += 7) text[i] = static_cast<char>(i >> 3);
    EXPECT_EQ(hash_of_file(folder.write("file", text)), hash_of(text)) << size;
  }
  EXPECT_THROW(hash_of_file(folder.path("none")), InputError);
  EXPECT_THROW(hash_of_file(folder.path("")), InputError);
}

TEST(Hash, IsAnotherForEveryBit) {
  const std::string text = "the quick brown fox";
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string other = text;
    other[bit / 8] = static_cast<char>(other[bit / 8] ^ (1 << bit % 8));
    EXPECT_NE(hash_of(other), hash_of(text)) << bit;
  }
}

}  // namespace
}  // namespace cosim
