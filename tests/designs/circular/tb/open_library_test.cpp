// The library of the classes that are open as a whole: built where it is not there, and nowhere
// else.
#include "tb/dut/open_dut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "tb/sim/bench.h"
#include "tb/sim/list.h"
#include "tb/util/scratch.h"
#include "tests/support/error_of.h"

namespace cosim::circular {
namespace {

namespace fs = std::filesystem;

// One that `cmake` is to make.
struct Library {
  explicit Library(const char* cmake) : cmake_(cmake) {
    std::ofstream(folder() + "/CMakeCache.txt");
  }
  std::string folder() const { return scratch_.path().string(); }
  OpenLibrary open() const { return {file_.c_str(), "circular_open", cmake_, folder_.c_str()}; }
  std::string refusal() const {
    return test::error_of([&] { open_maker_in(open(), "circularW4"); });
  }
  const std::string& file() const { return file_; }

 private:
  Scratch scratch_;
  const char* cmake_;
  std::string folder_ = folder(), file_ = folder() + "/made.so";
};

TEST(OpenLibrary, IsNotBuiltWhereItIsThere) {
  for (const auto& bench : benches()) {
    if (bench->title() == "circular W=4") bench->prepare_replays();
  }
  const fs::path all = fs::path(COSIM_LANES_FOLDER).parent_path() / "tb/open/circular";
  const fs::directory_iterator built(all);
  ASSERT_NE(built, fs::directory_iterator{});
  const std::string file = built->path().string();
  const OpenLibrary library{file.c_str(), "circular_open", "false", "none"};
  const std::unique_ptr<OpenInstance> one(open_maker_in(library, "circularW4")(1));
  const auto ports = one->ports();
  EXPECT_TRUE(std::any_of(ports.begin(), ports.end(),
                          [](const PortNet& p) { return std::string(p.name) == "clk"; }));
  EXPECT_NE(
      test::error_of([&] { open_maker_in(library, "circularW5"); }).find("cannot be loaded: "),
      std::string::npos);
}
TEST(OpenLibrary, ThatCannotBeBuiltIsNamed) {
  EXPECT_EQ(Library("false").refusal(), "circular_open: cannot be built: ");
}
// Its name follows from the RTL: what is made now has another.
TEST(OpenLibrary, OfOtherRtlIsRefused) {
  EXPECT_EQ(Library("true").refusal(),
            "circular_open: the RTL has changed since this program was built: build it again");
}
TEST(OpenLibrary, ThatIsNoneIsRefused) {
  const Library library("true");
  std::ofstream(library.file()) << "half a file";
  EXPECT_EQ(library.refusal().find(library.file() + ": cannot be loaded: "), 0U);
}

}  // namespace
}  // namespace cosim::circular
