// Tests by hand, on a counter whose RTL is its model, with and without a fault.
#include "tb/sim/directed.h"

#include <cstdlib>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tests/support/error_of.h"
#include "tests/support/has.h"
#include "tests/support/model_adapter.h"
#include "tests/support/struct_design.h"

namespace cosim::counted {

using clocked::Bit, clocked::UInt;

struct Counted {
  static constexpr const char* name = "counted";
  struct In {
    Bit rst;     // at 0
    UInt<3> by;  // a step
  };
  struct Out {
    UInt<8> sum;  // the sum so far
  };
  static constexpr auto reset = clocked::active_high<&In::rst>;

  UInt<8> total = 0;

  Out clock(const In& in) {
    const Out out{.sum = total};
    total = mux(in.rst, 0, total + in.by);
    return out;
  }
  auto legal(const In& in) const { return clocked::stated({{"by is not 6", in.by != 6}}); }
};
using Design = test::StructDesign<Counted>;

// Its sum is 1 more from `faulty` on.
template <Word faulty>
class Rtl final : public test::ModelAdapter<Design, Design::Params{}> {
 public:
  using ModelAdapter::ModelAdapter;
  Outputs outputs() const override {
    auto words = to_words(ModelAdapter::outputs());
    words[0] += to_words(registers())[0] >= faulty ? 1 : 0;
    return from_words<Outputs>(words);
  }
};

namespace {

using In = Counted::In;
using Out = Counted::Out;

const DesignBench<Design> good(dut_maker<Rtl<1000>>());
const DesignBench<Design> bad(dut_maker<Rtl<20>>());

TEST(Directed, DrivesClocksAndTells) {
  Directed<Counted> bench(good);
  EXPECT_EQ(bench.out().sum, 0);
  bench.in.by = 3;
  EXPECT_EQ(bench.clocks(4).sum, 9);  // during the fourth clock
  EXPECT_EQ(bench.state().total, 12);
  bench.in.by = 0;
  EXPECT_EQ(bench.clock().sum, 12);
}

TEST(Directed, ClocksUntilAtMost) {
  Directed<Counted> bench(good);
  bench.in.by = 1;
  EXPECT_TRUE(bench.until([](const Out& out) { return out.sum == 4; }, 5));
  EXPECT_FALSE(bench.until([](const Out& out) { return out.sum == 9; }, 4));
  EXPECT_EQ(bench.out().sum, 8);
}

TEST(Directed, CallsDriversBeforeAClockAndMonitorsAfter) {
  Directed<Counted> bench(good);
  std::vector<Word> seen;
  // The same step as the sum of the clock before, but not more than 4: 1 first.
  bench.add([](In& in, const Out& last) { in.by = last.sum == 0 ? 1 : 4; });
  bench.add([](In& in, const Out&) { in.by = in.by + 1; });
  bench.watch([&](const In& in, const Out& out) {
    seen.push_back(static_cast<Word>(in.by));
    seen.push_back(static_cast<Word>(out.sum));
  });
  bench.clocks(3);
  EXPECT_EQ(seen, (std::vector<Word>{2, 0, 2, 2, 5, 4}));
}

TEST(Directed, RefusesInputsThatNeverCome) {
  Directed<Counted> bench(good);
  bench.clock();
  bench.in.by = 6;
  EXPECT_EQ(test::error_of([&] { bench.clock(); }),
            "counted: clock 1: inputs that break an assumption: by is not 6");
}

TEST(Directed, RefusesAModelThatIsNotBuilt) {
  EXPECT_EQ(
      test::error_of([] { const Directed<Counted> bench; }),
      "cosim::counted::Counted: no design was built with it as its model in this configuration");
  EXPECT_EQ(&directed_choice({&good}, typeid(Counted)), &good);
}

class DirectedFailure : public testing::Test {
 protected:
  DirectedFailure() { setenv("COSIM_FAILURES", folder_.path().c_str(), 1); }
  ~DirectedFailure() override {
    if (before_.empty()) {
      unsetenv("COSIM_FAILURES");
    } else {
      setenv("COSIM_FAILURES", before_.c_str(), 1);
    }
    present_test = nullptr;
  }
  std::string kept(const std::string& name) const { return (folder_.path() / name).string(); }

 private:
  Scratch folder_;
  std::string before_ = std::getenv("COSIM_FAILURES") ? std::getenv("COSIM_FAILURES") : "";
};

TEST_F(DirectedFailure, ADifferenceIsThrownAndKept) {
  present_test = [] { return PresentTest{"Sum.Grows", false}; };
  Directed<Counted> bench(bad);
  bench.in.by = 7;
  std::string text;
  try {
    bench.clocks(100);
  } catch (const Differ& differ) {
    text = differ.what();
  }
  // 21 on the fourth clock.
  EXPECT_EQ(text.substr(0, text.find('\n')), "first difference: clock 3, sum");
  EXPECT_TRUE(test::has(text, "kept in: " + kept("counted-Sum.Grows")));
  const std::string stimulus = read_file(kept("counted-Sum.Grows/stimulus.stim"));
  test::expect_has(stimulus, {"origin Sum.Grows\n", "\n0-3 "});
  EXPECT_TRUE(std::filesystem::exists(kept("counted-Sum.Grows/smallest.stim")));
}

TEST_F(DirectedFailure, ATestThatFailsOtherwiseLeavesItsClocks) {
  present_test = [] { return PresentTest{"Sum.IsSix", true}; };
  testing::internal::CaptureStdout();
  {
    Directed<Counted> bench(good);
    bench.in.by = 5;
    bench.clocks(2);
  }
  EXPECT_EQ(
      testing::internal::GetCapturedStdout(),
      "RTL and model are the same on all 2 clocks\nkept in: " + kept("counted-Sum.IsSix") + "\n");
  EXPECT_TRUE(std::filesystem::exists(kept("counted-Sum.IsSix/stimulus.stim")));
  EXPECT_TRUE(std::filesystem::exists(kept("counted-Sum.IsSix/wave.fst")));
}

TEST_F(DirectedFailure, ATestThatPassesLeavesNothing) {
  present_test = [] { return PresentTest{"Sum.IsSeven", false}; };
  { Directed<Counted>(good).clocks(2); }
  EXPECT_FALSE(std::filesystem::exists(kept("counted-Sum.IsSeven")));
}

}  // namespace
}  // namespace cosim::counted
