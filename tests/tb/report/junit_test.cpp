// A verdict as CI services show it.
#include "tb/report/junit.h"

#include <gtest/gtest.h>

#include "tests/support/has.h"

namespace cosim {
namespace {

using End = JunitCase::End;

TEST(Junit, AnEqualIsACaseThatPassed) {
  EXPECT_EQ(junit_text({"cosim equiv", "uart", End::passed, "", "uart: equal\n", 1.25}),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"cosim equiv\" tests=\"1\" failures=\"0\" errors=\"0\" skipped=\"0\" "
            "time=\"1.250\">\n"
            "<testcase classname=\"cosim equiv\" name=\"uart\" time=\"1.250\">"
            "<system-out>uart: equal\n</system-out></testcase>\n</testsuite>\n");
}

TEST(Junit, ADifferenceIsAFailureAndAnErrorIsOne) {
  const std::string failed = junit_text({"s", "n", End::failure, "different", "a\nb\n", 0});
  EXPECT_TRUE(test::has(failed, "failures=\"1\" errors=\"0\""));
  EXPECT_TRUE(test::has(failed, "<failure type=\"different\" message=\"a\">a\nb\n</failure>"));
  const std::string wrong = junit_text({"s", "n", End::error, "input", "no", 0});
  EXPECT_TRUE(test::has(wrong, "failures=\"0\" errors=\"1\""));
  EXPECT_TRUE(test::has(wrong, "<error type=\"input\" message=\"no\">no\n</error>"));
}

TEST(Junit, HoldsNothingThatXmlDoesNot) {
  const std::string odd =
      junit_text({"s", "<\"&'>", End::failure, "a\"b", "\x01\xff<&>\"\t\x1b", 0});
  EXPECT_TRUE(test::has(odd, "name=\"&lt;&quot;&amp;'&gt;\""));
  EXPECT_TRUE(test::has(odd, "type=\"a&quot;b\" message=\"??&lt;&amp;&gt;&quot;??\""));
}

}  // namespace
}  // namespace cosim
