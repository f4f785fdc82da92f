// A verdict and a finding as CI services show them.
#include "tb/sim/ci.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/support/has.h"

namespace cosim::ci {
namespace {

using End = Verdict::End;

TEST(Junit, AnEqualIsACaseThatPassed) {
  EXPECT_EQ(junit_text("cosim equiv", {{"uart", End::passed, "", "uart: equal\n", 1.25}}),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuite name=\"cosim equiv\" tests=\"1\" failures=\"0\" errors=\"0\" skipped=\"0\" "
            "time=\"1.250\">\n"
            "<testcase classname=\"cosim equiv\" name=\"uart\" time=\"1.250\">"
            "<system-out>uart: equal\n</system-out></testcase>\n</testsuite>\n");
}

TEST(Junit, CountsFailuresAndErrorsOfAllCases) {
  const std::string text = junit_text("s", {{"a", End::failure, "different", "a\nb\n", 1},
                                            {"b", End::error, "input", "no", 2},
                                            {"c", End::passed, "", "", 0.5},
                                            {"d", End::failure, "different", "c", 0}});
  EXPECT_TRUE(
      test::has(text, "tests=\"4\" failures=\"2\" errors=\"1\" skipped=\"0\" time=\"3.500\""));
  EXPECT_TRUE(test::has(text, "<failure type=\"different\" message=\"a\">a\nb\n</failure>"));
  EXPECT_TRUE(test::has(text, "<error type=\"input\" message=\"no\">no\n</error>"));
}

TEST(Junit, HoldsNothingThatXmlDoesNot) {
  const std::string odd =
      junit_text("s", {{"<\"&'>", End::failure, "a\"b", "\x01\xff<&>\"\t\x1b", 0}});
  EXPECT_TRUE(test::has(odd, "name=\"&lt;&quot;&amp;'&gt;\""));
  EXPECT_TRUE(test::has(odd, "type=\"a&quot;b\" message=\"??&lt;&amp;&gt;&quot;??\""));
}

TEST(Annotation, HasTheLinesOfAFailureInOne) {
  EXPECT_EQ(annotation("cosim sweep", {"core: 1, 2", End::failure, "mismatch", "50 %\nmore\n", 0}),
            "::error title=cosim sweep%3A core%3A 1%2C 2::50 %25%0Amore\n");
}

TEST(Annotation, OfAFindingIsAtItsFile) {
  EXPECT_EQ(annotation({"verilator", "WIDTH", false, "a,b.v", 12, "too wide"}),
            "::warning title=verilator,file=a%2Cb.v,line=12::too wide\n");
  EXPECT_EQ(annotation({"yosys", "", true, "", 0, "no top"}), "::error title=yosys::no top\n");
}

TEST(Annotation, IsForGitHubAlone) {
  const char* const before = std::getenv("GITHUB_ACTIONS");
  const std::string kept = before == nullptr ? "" : before;
  unsetenv("GITHUB_ACTIONS");
  EXPECT_FALSE(is_on_github());
  setenv("GITHUB_ACTIONS", "true", 1);
  EXPECT_TRUE(is_on_github());
  setenv("GITHUB_ACTIONS", kept.c_str(), 1);
}

TEST(Findings, AreReadFromWhatThreeToolsPrint) {
  const auto all = findings_in("t",
                               "%Warning-UNUSEDSIGNAL: rtl/a.v:12:15: Signal is not used: 'x'\n"
                               "   12 |   wire x;\n"
                               "%Error: rtl/a.v:3:1: syntax error\n"
                               "%Error: Exiting due to 2 error(s)\n"
                               "b.v:7: warning: implicit definition of wire\n"
                               "b.v:9: syntax error\n"
                               "ERROR: Module `c' not found\n");
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0].rule, "UNUSEDSIGNAL");
  EXPECT_EQ(all[0].file, "rtl/a.v");
  EXPECT_EQ(all[0].line, 12);
  EXPECT_FALSE(all[0].is_error);
  EXPECT_TRUE(all[1].is_error);
  EXPECT_EQ(all[1].line, 3);
  EXPECT_FALSE(all[2].is_error);
  EXPECT_EQ(all[3].file, "b.v");
  EXPECT_TRUE(all[3].is_error);
  EXPECT_EQ(all[4].file, "");
  EXPECT_EQ(all[4].text, "Module `c' not found");
}

TEST(Findings, OfAnotherFormAreNotLost) {
  const auto all = findings_in("t", "status 134\n");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].text, "status 134");
  EXPECT_TRUE(findings_in("t", "\n").empty());
}

TEST(Sarif, HasARunForEachToolAndAPlaceForEachFinding) {
  const auto log = nlohmann::json::parse(
      sarif_text({"verilator", "yosys"}, {{"verilator", "WIDTH", false, "a.v", 12, "too wide"},
                                          {"verilator", "", true, "", 0, "no top"}}));
  EXPECT_EQ(log["version"], "2.1.0");
  ASSERT_EQ(log["runs"].size(), 2U);
  EXPECT_EQ(log["runs"][1]["tool"]["driver"]["name"], "yosys");
  EXPECT_TRUE(log["runs"][1]["results"].empty());
  const auto& found = log["runs"][0]["results"];
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0]["ruleId"], "WIDTH");
  EXPECT_EQ(found[0]["level"], "warning");
  EXPECT_EQ(found[0]["message"]["text"], "too wide");
  const auto& place = found[0]["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "a.v");
  EXPECT_EQ(place["region"]["startLine"], 12);
  EXPECT_FALSE(found[1].contains("locations"));
}

}  // namespace
}  // namespace cosim::ci
