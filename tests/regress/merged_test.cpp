// Parts that hold each by itself, and not together: a sweep that has compared nothing.
#include <gtest/gtest.h>

#include "tb/regress/report.h"
#include "tb/util/json.h"
#include "tests/fuzz/run.h"

namespace cosim::regress {
namespace {

Json nothing(const std::vector<Part>&) {
  return {{"failed", {{{"what", "nothing was compared"}}}}};
}
Json something(const std::vector<Part>&) { return {{"clocks", 7}}; }

Report report_of(fuzz::Units::Merge merge) {
  const fuzz::RunInAFolder folder(merge);
  const RunFolder run(folder.path(), folder.kinds());
  for (std::uint64_t s = 0; s < run.shards().size(); ++s) {
    append(run.path() / "results" / "a.jsonl", run.identity(),
           {s, "here", 1, Json{{"clocks", 1}}, ""});
  }
  return report(run, folder.kinds(),
                read_results(run.path() / "results", run.identity(), run.shards().size()));
}

TEST(Report, OfPartsThatHoldAndDoNotTogetherFails) {
  EXPECT_TRUE(report_of(something).holds);
  EXPECT_EQ(report_of(something).json["verdict"], "pass");
  const Report failed = report_of(nothing);
  EXPECT_FALSE(failed.holds);
  EXPECT_EQ(failed.json["verdict"], "fail");
  EXPECT_EQ(failed.json["failures"].size(), 4U);  // of each work
  EXPECT_EQ(failed.text.find("FAILED: a: all: nothing was compared\n"), 0U) << failed.text;
}

}  // namespace
}  // namespace cosim::regress
