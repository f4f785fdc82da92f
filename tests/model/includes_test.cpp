// Arrows between the folders point one way: a model knows no other one, and the harness none at
// all.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tb/util/pattern.h"
#include "tests/support/root.h"

namespace cosim::test {
namespace {

namespace fs = std::filesystem;

// "model", "linear" and "job.h" of model/linear/job.h.
std::vector<std::string> parts(const std::string& path) {
  std::vector<std::string> all;
  for (const fs::path& part : fs::path(path)) all.push_back(part.string());
  return all;
}

bool is_own(const std::vector<std::string>& part) {
  return part[0] == "tb" && (part[1] == "designs" || part[1] == "studies");
}

// Whether the file `from` of model/ or tb/ may include `what`.
bool may_include(const std::string& from, const std::string& what) {
  const std::vector<std::string> to = parts(what), at = parts(from);
  // What a model is written with.
  const bool language =
      to[0] == "model" && (to[1] == "core" || (to[1] == "clocked" && at[1] != "core"));
  const bool shared = language || (to[0] == "model" && to[1] == "plane" && at[1] != "core");
  if (at[0] == "model") {
    // What joins designs belongs to studies.
    const bool joins = at[1] == "prior_art" || at[1] == "toolpath";
    return to[0] == "model" && (joins || shared || to[1] == at[1]);
  }
  if (!is_own(at)) return to[0] == "tb" ? !is_own(to) : language;
  if (at[1] == "studies") return to[0] == "tb" || to[0] == "model";
  if (to[0] == "tb") return !is_own(to) || (to[1] == at[1] && to[2] == at[2]);
  return shared || (to[0] == "model" && to[1] == at[2]);
}

// "FROM WHAT" of every include of a file of the project in these folders.
std::vector<std::string> includes(const std::vector<std::string>& folders) {
  static const Pattern include(R"re(#include "([^"]*)")re");
  std::vector<std::string> all;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(project_root() / folder)) {
      const std::string kind = entry.path().extension().string();
      if (kind != ".h" && kind != ".cpp") continue;
      std::ifstream file(entry.path());
      const std::string from = fs::relative(entry.path(), project_root()).generic_string();
      for (std::string line; std::getline(file, line);) {
        const auto found = include.whole(line);
        if (found.empty()) continue;
        // What has no folder in front is made by CMake or Verilator.
        if (fs::exists(project_root() / found[1])) all.push_back(from + ' ' + found[1]);
      }
    }
  }
  return all;
}

TEST(Includes, PointOneWay) {
  std::size_t seen = 0;
  for (const std::string& one : includes({"model", "tb"})) {
    ++seen;
    const std::size_t space = one.find(' ');
    EXPECT_TRUE(may_include(one.substr(0, space), one.substr(space + 1))) << one;
  }
  EXPECT_GT(seen, 300U);
}

TEST(Includes, AreToldApart) {
  const auto expect = [](bool may, const std::string& from, std::vector<const char*> what) {
    for (const char* one : what) EXPECT_EQ(may_include(from, one), may) << from << ' ' << one;
  };
  expect(true, "model/dda/job.h",
         {"model/dda/curve.h", "model/core/value.h", "model/plane/point.h"});
  expect(false, "model/dda/job.h",
         {"model/circular/arc.h", "model/toolpath/piece.h", "tb/util/show.h",
          "tb/designs/dda/figures.h", "tests/support/root.h"});
  expect(true, "model/toolpath/walk.cpp", {"model/linear/oracle.h", "model/toolpath/plan.h"});
  expect(false, "model/core/fields.h", {"model/plane/point.h", "model/dda/job.h"});
  expect(true, "tb/proof/claims.h", {"model/core/fields.h", "tb/util/process.h"});
  expect(false, "tb/proof/claims.h",
         {"model/plane/point.h", "model/linear/linear.h", "tb/designs/linear/figures.h",
          "tb/studies/comparison/contest.h", "tests/support/root.h"});
  expect(true, "tb/designs/dda/figures.h",
         {"model/dda/job.h", "model/core/fields.h", "model/plane/point.h",
          "tb/designs/dda/sweeps.h", "tb/sim/sweep.h"});
  expect(false, "tb/designs/dda/figures.h",
         {"model/linear/job.h", "model/toolpath/plan.h", "tb/designs/linear/figures.h",
          "tb/studies/comparison/contest.h"});
  expect(
      true, "tb/studies/toolpath/path_run.h",
      {"model/linear/job.h", "tb/designs/circular/figures.h", "tb/studies/comparison/contest.h"});
}

}  // namespace
}  // namespace cosim::test
