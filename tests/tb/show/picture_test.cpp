// The picture of a run: it shows what is compared, marks where it differs, leaves out what it says
// it leaves out, and stays small enough for a page.
#include "tb/show/picture.h"

#include <deque>
#include <string>

#include "tests/support/has.h"

namespace cosim {
namespace {

std::size_t times(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

// A run of so many clocks in which every signal counts, and expected is actual but on one clock.
class PictureOf : public testing::Test {
 protected:
  void reg(const char* name, int index = -1) {
    shape_.compared.push_back({name, 16, Format::number, "", "what it is <for>"});
    shape_.compared.back().index = index;
    ++shape_.registers;
  }
  WavePicture picture(std::uint64_t clocks, std::optional<std::uint64_t> wrong) {
    PictureSink sink;
    WaveRange range{0, clocks - 1, clocks, wrong, ""};
    sink.begin(shape_, range, {});
    for (WaveClock now; now.clock < clocks; ++now.clock) {
      const std::size_t n = shape_.compared.size();
      now.expected.clear();
      for (const Field& f : shape_.compared) {
        now.expected.push_back(f.index > 0 ? 7 : static_cast<Word>(1000 + now.clock));
      }
      now.actual = now.expected;
      now.differs.assign(n, false);
      now.compared.assign(n, now.clock != meaningless_);
      if (now.clock == wrong) {
        now.actual[0] = 5555;
        now.differs[0] = true;
        range.signal = label_of(shape_.compared[0]);
      }
      sink.clock(now);
    }
    sink.end(range);
    return sink.take();
  }

  WaveShape shape_;
  std::uint64_t meaningless_ = ~std::uint64_t{0};
};

TEST_F(PictureOf, ADifferenceShowsBothValuesAtTheMarkedClock) {
  reg("a<b");
  reg("same");
  const WavePicture p = picture(100, 60);
  EXPECT_LE(p.first, 60U);
  EXPECT_GE(p.last, 60U);
  EXPECT_LT(p.last - p.first, 40U);
  EXPECT_EQ(p.clocks, 100U);
  EXPECT_EQ(p.left_out, 0U);
  test::expect_has(p.wave, {">a&lt;b expected<", ">a&lt;b actual<", ">same<", ">first difference<",
                            ">First difference: a&lt;b<", "&lt;for&gt;"});
  // In the group of the difference and among the registers: the value that is wrong, and the one
  // that is right, are red; no other is.
  EXPECT_EQ(times(p.wave, ">5555</text>"), 2U);
  EXPECT_EQ(times(p.wave, "class=\"differs\""), 4U);
  EXPECT_EQ(times(p.wave, "class=\"mark\""), 1U);
  EXPECT_FALSE(test::has(p.wave, "a<b"));
}

TEST_F(PictureOf, ARunWithoutADifferenceBeginsAtItsBegin) {
  reg("a");
  const WavePicture p = picture(1000, {});
  EXPECT_EQ(p.first, 0U);
  EXPECT_FALSE(test::has(p.wave, "class=\"mark\""));
  EXPECT_FALSE(test::has(p.wave, "class=\"differs\""));
  EXPECT_TRUE(test::has(p.wave, '>' + std::to_string(1000 + p.last) + '<'));
  EXPECT_FALSE(test::has(p.wave, '>' + std::to_string(1000 + p.last + 1) + '<'));
}

TEST_F(PictureOf, AShortRunShowsAllOfIt) {
  reg("a");
  const WavePicture p = picture(12, 11);
  EXPECT_EQ(p.first, 0U);
  EXPECT_EQ(p.last, 11U);
}

TEST_F(PictureOf, AMemoryHasOnlyTheWordsThatChange) {
  for (int i = 0; i < 50; ++i) reg("mem", i);
  const WavePicture p = picture(20, {});
  EXPECT_TRUE(test::has(p.wave, ">mem[0]<"));
  EXPECT_FALSE(test::has(p.wave, ">mem[1]<"));
  EXPECT_EQ(p.left_out, 49U);
  EXPECT_FALSE(p.is_cut);
}

TEST_F(PictureOf, AValueThatMeansNothingIsHatched) {
  reg("a");
  EXPECT_FALSE(test::has(picture(9, {}).wave, "class=\"off\""));
  meaningless_ = 4;
  EXPECT_EQ(times(picture(9, {}).wave, "class=\"off\""), 1U);
}

TEST_F(PictureOf, AGreatManySignalsStaysSmall) {
  std::deque<std::string> names;
  for (int i = 0; i < 5000; ++i) reg(names.emplace_back("r" + std::to_string(i)).c_str());
  const WavePicture p = picture(100, 50);
  EXPECT_LT(p.wave.size(), 450'000U);
  EXPECT_TRUE(p.is_cut);
  EXPECT_GT(p.left_out, 4000U);
  EXPECT_TRUE(test::has(p.wave, ">r0 expected<"));
}

}  // namespace
}  // namespace cosim
