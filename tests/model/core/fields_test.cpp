// Tables of fields: what is made from one.
#include "model/core/record.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/shapes.h"

namespace cosim::test {
namespace {

struct Sizes {
  int width = 7;
};
#define EXAMPLE_FIELDS(FIELD)                         \
  FIELD(enable, 1, flag, "3", "counts")               \
  FIELD(count, p.width, number, "4", "clocks so far") \
  FIELD(level, p.width + 1, ones_complement.with_fraction(3), "", "signed")
COSIM_RECORD(Example, EXAMPLE_FIELDS, Sizes);

TEST(Record, HasOneMemberAFieldInOrder) {
  static_assert(Example<Word>::size == 3);
  Example<Word> e;
  EXPECT_EQ(to_words(e), (Words<Example<Word>>{0, 0, 0}));
  e.enable = 1;
  e.count = 99;
  e.level = 200;
  EXPECT_EQ(to_words(e), (Words<Example<Word>>{1, 99, 200}));
  EXPECT_EQ(to_words(from_words<Example<Word>>({5, 6, 7})), (Words<Example<Word>>{5, 6, 7}));
  EXPECT_EQ(from_words<Example<Word>>({5, 6, 7}).count, 6);
}

TEST(Record, KnowsItsFields) {
  const auto fields = Example<Word>::fields(Sizes{12});
  EXPECT_STREQ(fields[0].name, "enable");
  EXPECT_STREQ(fields[1].name, "count");
  EXPECT_EQ(fields[0].width, 1);
  EXPECT_EQ(fields[1].width, 12);
  EXPECT_EQ(fields[2].width, 13);
  EXPECT_EQ(fields[2].format, Format::ones_complement);
  EXPECT_EQ(fields[1].fraction, 0);
  EXPECT_EQ(fields[2].fraction, 3);
  EXPECT_STREQ(fields[1].source, "4");
  EXPECT_STREQ(fields[1].meaning, "clocks so far");
}

TEST(Record, IsSelectedAsAWhole) {
  const auto a = from_words<Example<Word>>({1, 2, 3});
  const auto b = from_words<Example<Word>>({4, 5, 6});
  EXPECT_EQ(to_words(select(true, a, b)), to_words(a));
  EXPECT_EQ(to_words(select(false, a, b)), to_words(b));
}

template <class Design>
class Tables : public testing::Test {};
TYPED_TEST_SUITE(Tables, Designs, DesignNames);

// Words hold every field, and a name means one thing within a design's pins or registers.
TYPED_TEST(Tables, AreSound) {
  const auto check = [](const auto& fields, std::set<std::string>& names) {
    for (const Field& f : fields) {
      EXPECT_GE(f.width, 1) << f.name;
      EXPECT_LE(f.width, 64) << f.name;
      EXPECT_TRUE(f.format != Format::flag || f.width == 1) << f.name;
      EXPECT_TRUE(f.fraction == 0 || (is_signed(f) || f.format == Format::number)) << f.name;
      EXPECT_LE(f.fraction, 18) << f.name;
      // That of a struct stands in comments.
      EXPECT_TRUE(*f.meaning != '\0' || requires { typename TypeParam::First; }) << f.name;
      EXPECT_TRUE(names.insert(f.name).second) << f.name << " twice";
    }
  };
  for_each_shape<TypeParam>([&](const auto& p) {
    std::set<std::string> pins, registers;
    check(TypeParam::template Inputs<Word>::fields(p), pins);
    check(TypeParam::template Outputs<Word>::fields(p), pins);
    check(TypeParam::template Registers<Word>::fields(p), registers);
  });
}

}  // namespace
}  // namespace cosim::test
