// Ctrl-C in a sweep: it says what it had finished, and leaves nothing behind.
// Needs: linear, circular
#include <gtest/gtest.h>

#include <csignal>

#include "tests/cli/program.h"

namespace cosim::cli {
namespace {

void expect_stopped(int signal) {
  const Folder folder;
  // On a slow machine nothing is done yet, which it says too: then it gets more time.
  Ended e;
  int after = 700;
  do {
    e = cosim_signalled({"sweep", "linear", "--hostile", "400000000000", "--m", "5", "--n", "2",
                         "--failures", folder.path("failures")},
                        signal, after);
    after *= 2;
  } while (after < 600'000 && e.out.find("; 0 of") != std::string::npos);
  EXPECT_EQ(e.status, 128 + signal);
  EXPECT_EQ(e.err, "");
  const std::vector<std::string> all = lines(e.out);
  ASSERT_EQ(all.size(), 2U) << e.out;
  EXPECT_TRUE(has(all[0], "linear M=5 N=2, any value on any pin on any clock: not finished; "));
  EXPECT_TRUE(has(all[0], " of 400000000 cases matched"));
  EXPECT_FALSE(has(all[0], "; 0 of"));
  EXPECT_EQ(all[1], "interrupted: 0 of 1 sweep finished");
  EXPECT_FALSE(folder.holds("failures"));
}
TEST(InterruptedSweep, SaysWhatItHadFinished) { expect_stopped(SIGINT); }

// Stopped in the second of several sweeps.
TEST(InterruptedSweep, NamesThoseItHadFinished) {
  const Ended e = cosim_signalled({"sweep", "circular", "--hostile", "5000000"}, SIGINT, 600'000,
                                  Until::a_line);
  EXPECT_EQ(e.status, 128 + SIGINT);
  const std::vector<std::string> all = lines(e.out);
  ASSERT_GE(all.size(), 3U) << e.out;
  const std::size_t finished = all.size() - 2;
  const std::string clocks = ", any value on any pin on any clock: ";
  for (std::size_t i = 0; i < finished; ++i) {
    EXPECT_TRUE(has(all[i], clocks + "5000000 clocks"));
  }
  EXPECT_TRUE(all[0].starts_with("circular W=4" + clocks)) << all[0];
  EXPECT_TRUE(has(all[finished], clocks + "not finished; ")) << e.out;
  EXPECT_TRUE(all.back().starts_with("interrupted: " + std::to_string(finished) + " of "))
      << all.back();
}

TEST(InterruptedSweep, EndsOnATerminateToo) { expect_stopped(SIGTERM); }

// One signal is enough, also for a model that never comes back.
TEST(InterruptedRun, EndsThoughTheModelLoopsForEver) {
  const Folder folder;
  setenv("COSIM_FAULTY_LOOPS", folder.path("loops").c_str(), 1);
  const Ended e = faulty_signalled({"sweep", "linear", "--m", "32", "--n", "26", "--random", "3"},
                                   SIGTERM, [&] { return folder.holds("loops"); });
  unsetenv("COSIM_FAULTY_LOOPS");
  EXPECT_EQ(e.status, 128 + SIGTERM) << e.err;
  EXPECT_EQ(e.err, "");
}

// What is half written goes, what stood there stays.
TEST(InterruptedRun, LeavesNoHalfFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Folder folder;
    folder.write("csv", "kept\n");
    const Ended e = cosim_signalled({"arc", "--radius", "4294967295", "--csv", folder.path("csv")},
                                    signal, [&] { return folder.names().size() > 1; });
    EXPECT_EQ(e.status, 128 + signal);
    EXPECT_EQ(e.err, "");
    EXPECT_EQ(folder.text("csv"), "kept\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"csv"});
  }
}

TEST(InterruptedRun, LeavesNoHalfWave) {
  const Folder folder;
  const Arguments wave{"line", "--major", "100000000",         "--minor",
                       "3",    "--wave",  folder.path("w.fst")};
  // The wave takes many seconds from its first file on.
  const Ended e = cosim_signalled(wave, SIGTERM, [&] { return !folder.names().empty(); });
  EXPECT_EQ(e.status, 128 + SIGTERM);
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace cosim::cli
