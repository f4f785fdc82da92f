// Hostile clocks on a device of OpenCL, PoCL's CPU where there is no card: the result is that of
// one case at a time, with good RTL and with faults in it.
#include <gtest/gtest.h>

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>

#include "model/core/input_error.h"
#include "tests/rtl/variant_lanes.h"
#include "tests/support/designs.h"

namespace cosim::test {
namespace {

constexpr std::uint64_t seed = 1;

// Why there is no device; nothing where there is one.
const std::optional<std::string>& missing() {
  static const std::optional<std::string> why = []() -> std::optional<std::string> {
    try {
      lanes::Device();
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }();
  return why;
}

template <class Design>
void expect_as_alone(const Variant<Design>& v, std::initializer_list<std::uint64_t> lengths,
                     bool has_fault) {
  SCOPED_TRACE(v.name + ": " + v.what);
  const std::shared_ptr<lanes::Gpu> gpu =
      lanes::on_gpu(v.bench->title(), nets::played_of<Design>(v.bench->params()), source_of(v),
                    COSIM_LANES_FOLDER);
  for (const std::uint64_t clocks : lengths) {
    const Result alone = run_sweep(hostile_sweep(*v.bench, seed, clocks), 1);
    ASSERT_EQ(alone.mismatch.has_value(), has_fault);
    for (const unsigned threads : {1U, 2U}) {
      expect_equal(run_sweep(lanes::hostile_sweep(*v.bench, gpu, seed, clocks), threads), alone);
    }
  }
}

template <class Design>
class OnAGpu : public testing::Test {
 protected:
  void SetUp() override {
    if (missing()) GTEST_SKIP() << *missing();
  }
};
TYPED_TEST_SUITE(OnAGpu, Designs, DesignNames);

TYPED_TEST(OnAGpu, GoodRtlMatches) {
  const auto& all = variants<TypeParam>();
  // The last one by name has few bits: of 16 PoCL takes a minute to compile the kernel.
  const auto good = std::find_if(all.rbegin(), all.rend(),
                                 [](const auto& v) { return v.name.starts_with("shipped/"); });
  ASSERT_NE(good, all.rend());
  expect_as_alone(*good, {1, 1000, 70'123}, false);
}

// The case, the clock and the signal are those that lockstep names.
TYPED_TEST(OnAGpu, AFaultIsFoundWhereLockstepFindsIt) {
  for (const auto& v : variants<TypeParam>()) {
    if (v.name == "faults/priority_missing" || v.name == "faults/two_from_one" ||
        v.name == "faults/borrow_missed") {
      expect_as_alone(v, {100'000}, true);
      return;
    }
  }
  FAIL() << "no fault to try it with";
}

}  // namespace
}  // namespace cosim::test
