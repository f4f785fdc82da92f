// Values as a person reads them, in every format.
#include "tb/util/show.h"

#include <gtest/gtest.h>

namespace cosim {
namespace {

Field field(int width, Format format, int fraction = 0) {
  return {"x", width, format, "", "", fraction};
}

TEST(ShowShort, FlagsAndNumbers) {
  EXPECT_EQ(show_short(field(1, Format::flag), 1), "1");
  EXPECT_EQ(show_short(field(1, Format::flag), 0), "0");
  EXPECT_EQ(show_short(field(5, Format::number), 27), "27");
  EXPECT_EQ(show_short(field(64, Format::number), -1), "18446744073709551615");
}

TEST(ShowShort, NamesOfValuesWithNumbersBehindThem) {
  static constexpr const char* colors[] = {"red", "green"};
  Field color = field(2, Format::number);
  color.names = colors;
  color.named = 2;
  EXPECT_EQ(show_short(color, 1), "green");
  EXPECT_EQ(show_short(color, 2), "2");
  EXPECT_EQ(show(color, 1), "01 (green)");
  EXPECT_EQ(show_width(color), 5U);
  EXPECT_EQ(parse_short(color, "green"), 1);
  EXPECT_EQ(parse_short(color, "3"), 3);
  EXPECT_FALSE(parse_short(color, "1"));
  EXPECT_FALSE(parse_short(color, "blue"));
}

TEST(ShowShort, BitStrings) {
  EXPECT_EQ(show_short(field(5, Format::bits), 0b01010), "01010");
  EXPECT_EQ(show_short(field(16, Format::bits), 1), "0000000000000001");
  EXPECT_EQ(show_short(field(17, Format::bits), 0x1abcd), "1abcd");
  EXPECT_EQ(show_short(field(63, Format::bits), 0x5a), "000000000000005a");
  EXPECT_EQ(show_short(field(64, Format::bits), -1), "ffffffffffffffff");
}

TEST(ShowShort, SignedNumbers) {
  EXPECT_EQ(show_short(field(5, Format::twos_complement), 0b01111), "15");
  EXPECT_EQ(show_short(field(5, Format::twos_complement), 0b11111), "-1");
  EXPECT_EQ(show_short(field(5, Format::twos_complement), 0b10000), "-16");
  EXPECT_EQ(show_short(field(5, Format::ones_complement), 0b01111), "15");
  EXPECT_EQ(show_short(field(5, Format::ones_complement), 0b11110), "-1");
  EXPECT_EQ(show_short(field(5, Format::ones_complement), 0b10000), "-15");
}

TEST(ShowShort, TellsTheTwoZerosApart) {
  EXPECT_EQ(show_short(field(5, Format::ones_complement), 0), "0");
  EXPECT_EQ(show_short(field(5, Format::ones_complement), 0b11111), "-0");
  EXPECT_EQ(show_short(field(8, Format::ones_complement, 2), 0), "0.00");
  EXPECT_EQ(show_short(field(8, Format::ones_complement, 2), 0xff), "-0.00");
}

// 12.25 is 1100.01, its negative the complement of that.
TEST(ShowShort, Quarters) {
  EXPECT_EQ(show_short(field(8, Format::ones_complement, 2), 0b00101011), "10.75");
  EXPECT_EQ(show_short(field(8, Format::ones_complement, 2), 0b00110001), "12.25");
  EXPECT_EQ(show_short(field(8, Format::ones_complement, 2), 0b11001110), "-12.25");
  EXPECT_EQ(show_short(field(8, Format::ones_complement, 2), 0b11111110), "-0.25");
  EXPECT_EQ(show_short(field(8, Format::ones_complement, 2), 0b11111101), "-0.50");
}

// 5.375 is 101.011; in two's complement the code of -5.375 is 32 - 5.375 = 26.625, 11010.101.
TEST(ShowShort, FractionsOfAnyFormat) {
  EXPECT_EQ(show_short(field(8, Format::number, 3), 0b11010101), "26.625");
  EXPECT_EQ(show_short(field(8, Format::twos_complement, 3), 0b00101011), "5.375");
  EXPECT_EQ(show_short(field(8, Format::twos_complement, 3), 0b11010101), "-5.375");
  EXPECT_EQ(show_short(field(4, Format::number, 4), 1), "0.0625");
  EXPECT_EQ(show_short(field(64, Format::number, 18), -1), "70368744177663.999996185302734375");
}

TEST(ParseShort, TakesWhatIsShown) {
  for (const Format format : {Format::flag, Format::bits, Format::number, Format::twos_complement,
                              Format::ones_complement}) {
    for (const int fraction : {0, 1, 3}) {
      const Field f = field(6, format, fraction);
      for (Word code = 0; code >> 6 == 0; ++code) {
        EXPECT_EQ(parse_short(f, show_short(f, code)), code) << show_short(f, code);
      }
    }
  }
}

TEST(ParseShort, RefusesAllElse) {
  const Field number = field(5, Format::number), fixed = field(5, Format::twos_complement, 2);
  for (const char* text : {"", "-", "-0", "-1", "+1", "32", "01", "1.", "1.0", "1x", " 1"}) {
    EXPECT_FALSE(parse_short(number, text)) << text;
  }
  for (const char* text :
       {"", ".", "1", "1.", "1.5", ".50", "1.500", "1.51", "-0.00", "4.00", "-4.25", "1.-5"}) {
    EXPECT_FALSE(parse_short(fixed, text)) << text;
  }
  EXPECT_EQ(parse_short(fixed, "-4.00"), 0b10000);
  EXPECT_FALSE(parse_short(field(5, Format::twos_complement), "-0"));
}

TEST(Show, HasTheBitsAndWhatTheyStandFor) {
  EXPECT_EQ(show(field(1, Format::flag), 1), "1");
  EXPECT_EQ(show(field(5, Format::number), 27), "11011 (27)");
  EXPECT_EQ(show(field(5, Format::bits), 0b01010), "01010");
  EXPECT_EQ(show(field(20, Format::bits), 0xabcde), "10101011110011011110 (abcde)");
  EXPECT_EQ(show(field(5, Format::ones_complement), 0b11110), "11110 (-1)");
  EXPECT_EQ(show(field(8, Format::ones_complement, 2), 0b11001110), "11001110 (-12.25)");
}

TEST(ShowWidth, IsTheLongestThereIs) {
  for (const Format format :
       {Format::bits, Format::number, Format::twos_complement, Format::ones_complement}) {
    for (int width = 2; width <= 12; ++width) {
      for (const int fraction : {0, 2}) {
        const Field f = field(width, format, fraction);
        std::size_t longest = 0;
        for (Word code = 0; code >> width == 0; ++code) {
          longest = std::max(longest, show_short(f, code).size());
        }
        EXPECT_EQ(show_width(f), longest)
            << "format " << static_cast<int>(format) << " width " << width;
      }
    }
  }
  EXPECT_EQ(show_width(field(1, Format::flag)), 1U);
  EXPECT_EQ(show_width(field(63, Format::bits)), 16U);
}

}  // namespace
}  // namespace cosim
