// Lines that were cut off are seen wherever the cut is, and cost no other line.
#include "tb/regress/results.h"

#include "tests/support/folder.h"

namespace cosim::regress {
namespace {

Line line(std::uint64_t shard) {
  return {shard, "here", 0.5, Json{{"clocks", 100 + shard}, {"text", "\"}\n{ \xc3\xa4"}}, ""};
}

const std::string run = "a run";

TEST(Results, OfEveryCutAreWhatWasWhole) {
  const test::Folder whole;
  for (std::uint64_t s = 0; s < 3; ++s) append(whole.path("a.jsonl"), run, line(s));
  const std::string text = whole.text("a.jsonl");
  for (std::size_t size = 0; size <= text.size(); ++size) {
    const test::Folder folder;
    folder.write("a.jsonl", text.substr(0, size));
    const std::string left = text.substr(0, size);
    const auto lines = static_cast<std::uint64_t>(std::count(left.begin(), left.end(), '\n'));
    const bool torn = !left.empty() && left.back() != '\n';

    const Results before = read_results(folder.path(""), run, 3);
    EXPECT_EQ(before.finished(), lines) << size;
    EXPECT_EQ(before.torn, torn ? 1U : 0U) << size;

    // What is appended then stands on a line of its own.
    append(folder.path("a.jsonl"), run, line(2));
    const Results after = read_results(folder.path(""), run, 3);
    ASSERT_TRUE(after.done[2]) << size;
    EXPECT_EQ(after.done[2]->result, line(2).result);
    // A line whose '\n' alone was lost is whole again.
    const bool healed = size + 1 == text.size() || (torn && text[size] == '\n');
    EXPECT_EQ(after.finished() + after.torn + after.twice, lines + (torn ? 1 : 0) + 1);
    if (!healed) EXPECT_EQ(after.torn, torn ? 1U : 0U) << size;
  }
}

TEST(Results, OfAShardCountOnce) {
  const test::Folder folder;
  append(folder.path("b.jsonl"), run, line(1));
  Line other = line(1);
  other.host = "there";
  append(folder.path("a.jsonl"), run, other);
  const Results results = read_results(folder.path(""), run, 2);
  EXPECT_EQ(results.finished(), 1U);
  EXPECT_EQ(results.twice, 1U);
  EXPECT_EQ(results.done[1]->host, "there") << "files in the order of their names";
}

TEST(Results, ThatCouldNotBeHadAreErrorsUntilTheyAre) {
  const test::Folder folder;
  Line failed{1, "here", 0, {}, "needs a solver"};
  append(folder.path("a.jsonl"), run, failed);
  EXPECT_EQ(read_results(folder.path(""), run, 2).errors.at(1), "needs a solver");
  append(folder.path("a.jsonl"), run, line(1));
  const Results results = read_results(folder.path(""), run, 2);
  EXPECT_TRUE(results.errors.empty());
  EXPECT_TRUE(results.done[1]);
}

// Whatever byte of a line is another one, or another run's.
TEST(Results, ThatWereChangedAreNone) {
  const test::Folder folder;
  append(folder.path("a.jsonl"), run, line(1));
  EXPECT_EQ(read_results(folder.path(""), "other", 2).torn, 1U);
  const std::string text = folder.text("a.jsonl");
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    for (const char c : {'0', '7', '-', '"', ' ', '[', '\n'}) {
      std::string changed = text;
      changed[at] = c;
      folder.write("a.jsonl", changed);
      const Results results = read_results(folder.path(""), run, 2);
      // Space between values says nothing.
      if (results.done[1]) EXPECT_EQ(results.done[1]->result, line(1).result) << changed;
      EXPECT_TRUE(results.done[1] ? results.torn == 0 : results.torn >= 1) << changed;
      EXPECT_FALSE(results.done[0]);
    }
  }
}

TEST(Results, OfNoShardOfTheRunAreNone) {
  const test::Folder folder;
  folder.write("a.jsonl",
               "null\n[]\n{}\n{\"shard\":0}\n{\"shard\":9,\"host\":\"\",\"seconds\":0,"
               "\"result\":{}}\n{\"shard\":0,\"host\":\"\",\"seconds\":0,\"result\":7}\n\n");
  const Results results = read_results(folder.path(""), run, 2);
  EXPECT_EQ(results.finished(), 0U);
  EXPECT_EQ(results.torn, 7U);
}

}  // namespace
}  // namespace cosim::regress
