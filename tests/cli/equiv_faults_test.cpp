// cosim equiv: every planted fault of a shipped design is another machine, seen at its outputs.
// Needs: linear
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/cli/equiv_pairs.h"

namespace cosim::cli {
namespace {

Arguments sources(const fs::path& folder) {
  Arguments files;
  for (const auto& one : fs::directory_iterator(folder)) {
    if (one.path().extension() == ".v") files.push_back(one.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(EquivFaults, AreDifferent) {
  // A code that is taken too soon is never used: the line has to be given another. So its outputs
  // are the same for ever, as pdr, scorr and dprove say each by itself; the lockstep sees its
  // register.
  const std::string unseen = "linear_faults_priority_missing";
  const Folder folder;
  int faults = 0;
  for (const auto& variant : fs::directory_iterator(COSIM_VARIANTS)) {
    const std::string name = variant.path().filename().string();
    if (!name.starts_with("linear_faults_") && !name.starts_with("linear_errata_")) continue;
    const Arguments gold = joined(
        {"equiv", "--top", "linear", "--netlists", "--failures", folder.path("kept"), "--gold"},
        sources(COSIM_VARIANTS "/linear_shipped_m16_n13"));
    const Arguments words = joined(joined(gold, {"--gate"}), sources(variant.path()));
    EXPECT_EQ(cosim(words).status, name == unseen ? 0 : 1) << name;
    ++faults;
  }
  EXPECT_GT(faults, 20);
}

}  // namespace
}  // namespace cosim::cli
