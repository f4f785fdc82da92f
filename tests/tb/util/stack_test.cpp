#include "tb/util/stack.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace cosim {
namespace {

// Tables of a design go by value.
TEST(Stack, HasRoomForLargeRecords) {
  allow_large_records();
  char last = 0;
  std::thread([&last] {
    std::array<volatile char, (std::size_t{40} << 20U)> large;
    for (std::size_t at = large.size(); at > 0; at -= std::size_t{1} << 20U) large[at - 1] = 'x';
    last = large.back();
  }).join();
  EXPECT_EQ(last, 'x');
}

}  // namespace
}  // namespace cosim
