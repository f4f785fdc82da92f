// The digest of examples/sha256 against the examples printed with the standard.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "examples/sha256/sha256.h"

namespace sha256_model {
namespace {

// Section 5.1.1: the message, a bit 1, zeros, its length in bits.
std::vector<Block<Word>> padded(const std::string& message) {
  std::string bytes = message + '\x80';
  while (bytes.size() % 64 != 56) bytes += '\0';
  for (int i = 7; i >= 0; --i) {
    bytes += static_cast<char>(8 * message.size() >> (8 * i) & 0xff);
  }
  std::vector<Block<Word>> blocks;
  for (std::size_t begin = 0; begin < bytes.size(); begin += 64) {
    Block<Word> block;
    for (std::size_t i = 0; i < 64; ++i) {
      const auto byte = static_cast<unsigned char>(bytes[begin + i]);
      Word& word = block.data[static_cast<int>(7 - i / 8)];
      word = shift_left(word, 8) | byte;
    }
    block.last = begin + 64 == bytes.size() ? 1 : 0;
    blocks.push_back(block);
  }
  return blocks;
}

std::string digest(const std::string& message) {
  const auto digests = Design::run({}, padded(message));
  if (digests.size() != 1) return "";
  std::string text;
  for (int i = 255; i >= 0; i -= 4) {
    const auto digit = shift_right(digests[0].data[i / 64], (i - 3) % 64) & 15;
    text += "0123456789abcdef"[digit];
  }
  return text;
}

TEST(Sha256, ThePrintedExamples) {
  EXPECT_EQ(digest("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(digest(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, AMessageBeginsWhereTheOneBeforeItEnds) {
  auto blocks = padded("abc");
  const auto again = padded("abc");
  blocks.insert(blocks.end(), again.begin(), again.end());
  const auto digests = Design::run({}, blocks);
  ASSERT_EQ(digests.size(), 2U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(digests[0].data[i], digests[1].data[i]);
}

}  // namespace
}  // namespace sha256_model
