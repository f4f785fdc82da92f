// What a long run says in a pipe: nothing at once, and then how things stand.
#include <gtest/gtest.h>

#include "tb/sim/progress.h"

namespace cosim::cli {
namespace {

TEST(StateLine, ComesNowAndThen) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  {
    StateLine line(std::chrono::seconds(1));
    line.show("0 of 2 decided");
    line.print("a row\n");
    line.show("1 of 2 decided");
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "a row\n");
  EXPECT_EQ(testing::internal::GetCapturedStderr().find("1 s: 1 of 2 decided\n"), 0U);
}

}  // namespace
}  // namespace cosim::cli
