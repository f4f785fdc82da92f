// The digest of examples/sha256 against the examples printed with the standard.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "examples/sha256/sha256.h"

namespace {

// Section 5.1.1: the message, a bit 1, zeros, its length in bits.
std::vector<Sha256::Block> padded(const std::string& message) {
  std::string bytes = message + '\x80';
  while (bytes.size() % 64 != 56) bytes += '\0';
  for (int i = 7; i >= 0; --i) {
    bytes += static_cast<char>(8 * message.size() >> (8 * i) & 0xff);
  }
  std::vector<Sha256::Block> blocks;
  for (std::size_t begin = 0; begin < bytes.size(); begin += 64) {
    Sha256::Block block{0, begin + 64 == bytes.size()};
    for (std::size_t i = 0; i < 64; ++i) {
      block.data = block.data << 8 | static_cast<unsigned char>(bytes[begin + i]);
    }
    blocks.push_back(block);
  }
  return blocks;
}

std::string digest(const std::string& message) {
  const auto digests = Sha256::run(padded(message));
  if (digests.size() != 1) return "";
  std::string text;
  for (int i = 252; i >= 0; i -= 4) {
    text += "0123456789abcdef"[digests[0].data.bits<4>(i).value()];
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
  const auto digests = Sha256::run(blocks);
  ASSERT_EQ(digests.size(), 2U);
  EXPECT_TRUE(digests[0].data == digests[1].data);
}

}  // namespace
