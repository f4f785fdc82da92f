// The fields of every design.
#include "model/core/fields.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/support/shapes.h"

namespace cosim::test {
namespace {

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
