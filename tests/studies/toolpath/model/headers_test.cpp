// Heads and ends of programs as posts and people write them: tests/toolpaths/headers/.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/studies/toolpath/model/helpers.h"
#include "tests/support/root.h"

namespace cosim::toolpath {
namespace {

namespace fs = std::filesystem;

// Says no modes, so that those the head leaves on are seen; ends where it began.
constexpr const char* kBody =
    "G0 X10 Y10\n"
    "G1 Z-1 F300\n"
    "X20\n"
    "G3 X25 Y15 R30 K0 P1\n"
    "G1 Y20\n"
    "G0 Z5\n"
    "X0 Y0\n";

struct HeaderCase {
  std::string name;
  std::string decision;
  std::string head;
  std::string end;
};

void PrintTo(const HeaderCase& c, std::ostream* out) { *out << c.name; }

void read_cases(const fs::path& path, std::vector<HeaderCase>& cases) {
  std::ifstream file(path);
  std::string* part = nullptr;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("==== ")) {
      const std::size_t colon = line.find(": ");
      cases.push_back({line.substr(5, colon - 5), line.substr(colon + 2), "", ""});
      part = &cases.back().head;
    } else if (line == "---- body") {
      part = &cases.back().end;
    } else {
      *part += line + "\n";
    }
  }
}

std::vector<HeaderCase> all_cases() {
  std::vector<HeaderCase> cases;
  const std::set<fs::path> files{
      fs::directory_iterator(test::project_root() / "tests/toolpaths/headers"), {}};
  for (const fs::path& file : files) {
    if (file.extension() == ".txt") read_cases(file, cases);
  }
  return cases;
}

// The motions without their places, which the head moves.
std::vector<Motion> path_of(const std::string& text) {
  std::vector<Motion> motions = read(text).motions;
  for (Motion& m : motions) m.place = {};
  return motions;
}

bool same(const Motion& a, const Motion& b) {
  return a.kind == b.kind && a.start == b.start && a.end == b.end && a.centre == b.centre &&
         a.sweep == b.sweep && a.full_circle == b.full_circle;
}

class Headers : public testing::TestWithParam<HeaderCase> {};

TEST_P(Headers, AreTakenOrRefused) {
  const HeaderCase& c = GetParam();
  const std::string program = c.head + kBody + c.end;
  const std::string refused = "refused ", taken_as = "taken as ";
  if (c.decision.starts_with(refused)) {
    EXPECT_EQ(error_of([&] { read(program); }), "p.ngc:" + c.decision.substr(refused.size()));
    return;
  }
  std::string alone = kBody;
  if (c.decision.starts_with(taken_as)) {
    alone = c.decision.substr(taken_as.size()) + "\n" + kBody;
  } else {
    ASSERT_EQ(c.decision, "taken");
  }
  ASSERT_EQ(error_of([&] { read(program); }), "");
  const std::vector<Motion> expected = path_of(alone), path = path_of(program);
  EXPECT_TRUE(std::equal(path.begin(), path.end(), expected.begin(), expected.end(), same));
}

INSTANTIATE_TEST_SUITE_P(Of, Headers, testing::ValuesIn(all_cases()));

TEST(Headers, AreAHundredAndMore) { EXPECT_GT(all_cases().size(), 100U); }

}  // namespace
}  // namespace cosim::toolpath
