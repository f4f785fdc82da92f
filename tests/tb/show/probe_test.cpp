// What a wave shows beside the fields is what the design's view has, if it has one.
#include "model/core/probe.h"

#include <gtest/gtest.h>

#include "tb/show/picture.h"
#include "tb/util/read_file.h"
#include "tests/support/folder.h"
#include "tests/support/has.h"
#include "tests/support/model_adapter.h"
#include "tests/support/struct_design.h"
#include "tests/support/vcd.h"

namespace cosim {
namespace {

// Two bits of shift register: a design without a view.
struct Shift {
  static constexpr const char* name = "shift";
  struct In {
    clocked::Bit in;  // what comes in
  };
  struct Out {
    clocked::Bit out;  // what came in before the last
  };

  clocked::Hex<clocked::UInt<2>> held = 0;  // the last two

  Out clock(const In& in) {
    const Out out{.out = held[1]};
    held = cat(held[0], in.in);
    return out;
  }
};
using Bare = test::StructDesign<Shift>;

// The same with one.
struct Seen : Bare {
  class View {
   public:
    static constexpr std::array levels{"low", "high"};
    static constexpr std::array<Probe, 3> probes(const Params&) {
      using enum Probe::Kind;
      return {
          {{"level", words, "line", "", 2, {}, Probe::Side::expected, levels},
           {"ones", number, "line", "Counted", 8, Format::number},
           {"sum", analog, "line", "Counted", 8, Format::twos_complement, Probe::Side::actual}}};
    }
    void clock(const Params&, const State<Word>& s, const Outputs<Word>& out) {
      level_ = to_words(out)[0];
      ones_ += to_words(s)[0] & 1;
      --sum_;
    }
    std::array<Word, 3> values() const { return {level_, ones_, sum_}; }

   private:
    Word level_ = 0, ones_ = 0, sum_ = 0;
  };
};

class ProbesOf : public test::InAFolder {
 protected:
  std::string draw(const AnyBench& bench) {
    const std::string path = folder.path("x.fst");
    Stimulus stimulus;
    stimulus.machine = bench.title();
    stimulus.clocks = {{1}, {1}, {0}, {1}};
    bench.draw_wave(path, stimulus, {});
    return path;
  }
  std::string text(const char* name) const { return read_file(folder.path(name)); }
};

TEST_F(ProbesOf, ADesignWithoutAViewAreNone) {
  const AnyBench& bench = test::model_bench<Bare, Bare::Params{}>();
  EXPECT_TRUE(bench.probes().empty());
  const std::string path = draw(bench);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"x.fst", "x.gtkw"}));
  EXPECT_TRUE(test::has(text("x.gtkw"), "cosim.actual.held[1:0]"));
  // Nor is a source named where the tables name none.
  EXPECT_TRUE(test::has(text("x.gtkw"), "-Pins\n"));
  EXPECT_TRUE(test::has(text("x.gtkw"), "-Registers\n"));
  if (!test::can_read_waves()) GTEST_SKIP() << "there is no fst2vcd";
  EXPECT_EQ(test::Vcd(path).at("cosim.actual.held", 20), "11");
}

TEST_F(ProbesOf, AViewAreInTheWave) {
  const std::string path = draw(test::model_bench<Seen, Bare::Params{}>());
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"x.fst", "x.gtkw", "x.level.txt"}));
  EXPECT_EQ(text("x.level.txt"), "0 low\n1 high\n");
  const std::string view = text("x.gtkw");
  EXPECT_TRUE(test::has(view, "@2022\n^1 x.level.txt\n+{level} cosim.line.level[1:0]\n"));
  // A number in decimals; the curve of a signed number, three lines higher.
  EXPECT_TRUE(test::has(view,
                        "@800200\n-Counted\n[color] 4\n@24\n+{ones} cosim.line.ones[7:0]\n"
                        "[color] 4\n@88420\n+{sum} cosim.line.sum[7:0]\n@20000\n-\n-\n-\n"
                        "@1000200\n-Counted\n"));
  if (!test::can_read_waves()) GTEST_SKIP() << "there is no fst2vcd";
  const test::Vcd wave(path);
  EXPECT_EQ(wave.at("cosim.line.level", 10), "00");
  EXPECT_EQ(wave.at("cosim.line.level", 20), "01");
  EXPECT_EQ(wave.at("cosim.line.ones", 35), "00000010");
  EXPECT_EQ(wave.at("cosim.line.expected_ones", 35), "00000010");
  EXPECT_EQ(wave.at("cosim.line.sum", 35), "11111100");
  EXPECT_FALSE(wave.at("cosim.line.expected_sum", 35));
  EXPECT_FALSE(wave.at("cosim.line.expected_level", 35));
}

}  // namespace
}  // namespace cosim
