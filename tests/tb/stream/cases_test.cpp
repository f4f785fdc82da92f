// What a model says of its transactions: the sentences of cases(), crossed and by the names of an
// enum.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/clocked/model.h"
#include "model/clocked/stream.h"

namespace cosim::clocked {
namespace {

enum class Color { red, green, blue };

struct Pixel {
  Enum<Color> color;
  UInt<4> level;
};

struct Screen {
  static auto cases(const Pixel& p) {
    return std::tuple{
        crossed(values(p.color), stated({{"dark", p.level < 2}, {"bright", p.level >= 2}})),
        stated({{"full", p.level == 15}})};
  }
};

struct Behind {
  static auto cases(const Pixel& p, const Pixel* before) {
    return stated({{"the same again", before != nullptr ? p.color == before->color : Bit(0)}});
  }
};

std::vector<std::string> happening(const Pixel& p) {
  std::vector<std::string> all;
  for_each_case(stream_cases<Screen, Pixel>(p, nullptr),
                [&](const std::string& a, const std::string& b, bool holds) {
                  if (holds) all.push_back(b.empty() ? a : a + ", " + b);
                });
  return all;
}

using Texts = std::vector<std::string>;

TEST(StreamCases, AreSentencesAndTheirCrosses) {
  EXPECT_EQ(happening({Color::green, 1}), (Texts{"green, dark"}));
  EXPECT_EQ(happening({Color::blue, 15}), (Texts{"blue, bright", "full"}));
  std::size_t number = 0;
  for_each_case(stream_cases<Screen, Pixel>(zero<Pixel>(), nullptr),
                [&](const char*, const char*, bool) { ++number; });
  EXPECT_EQ(number, 3U * 2U + 1U);
}

TEST(StreamCases, MayLookAtTheTransactionBefore) {
  static_assert(SaysStreamCases<Behind, Pixel> && SaysStreamCases<Screen, Pixel>);
  static_assert(!SaysStreamCases<Screen, Behind>);
  const Pixel red{Color::red, 0}, blue{Color::blue, 0};
  const auto same = [](const Pixel& p, const Pixel* before) {
    return static_cast<bool>(stream_cases<Behind>(p, before).front().holds);
  };
  EXPECT_FALSE(same(red, nullptr));
  EXPECT_FALSE(same(red, &blue));
  EXPECT_TRUE(same(red, &red));
}

TEST(StreamEnum, HasAsManyBitsAsItsNamesNeed) {
  static_assert(Enum<Color>::width == 2);
  static_assert(Enum<Color, 5>::width == 5);
  const Enum<Color> blue = Color::blue;
  EXPECT_TRUE(static_cast<bool>(blue == Color::blue) && static_cast<bool>(blue != Color::red));
  EXPECT_EQ(static_cast<Color>(blue), Color::blue);
  EXPECT_STREQ(blue.name(), "blue");
  EXPECT_STREQ(Enum<Color>(3).name(), "?");
}

}  // namespace
}  // namespace cosim::clocked
