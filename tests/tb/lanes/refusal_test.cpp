// What does not run in lanes is refused in one line that says why, before any tool is called.
#include <gtest/gtest.h>

#include <fstream>

#include "model/core/input_error.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tests/support/designs.h"
#include "tests/support/in_lanes.h"

namespace cosim::test {
namespace {

template <class Design>
class LanesRefuse : public testing::Test {
 protected:
  LanesRefuse() : bench_(*benches_of<Design>().front()), machine_(machine_of(bench_)) {
    played_ = machine_.first->played();
  }
  // Nothing is there to be made of, and nothing is left behind.
  std::string why(const proof::Source& source) const {
    try {
      lanes::built("it", played_, source, 64, scratch_.path() / "lanes");
    } catch (const InputError& error) {
      EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "lanes"));
      return error.what();
    }
    return "taken";
  }
  // The first file of its RTL with a line at its end.
  proof::Source with(const std::string& line) const {
    proof::Source source = machine_.second;
    const auto file = scratch_.path() / "changed.v";
    std::ofstream(file) << read_file(source.files.front().string()) << line << '\n';
    source.files.front() = file;
    return source;
  }

  const Bench<Design>& bench_;
  std::pair<const proof::BuiltMachine*, proof::Source> machine_;
  nets::Played played_;
  Scratch scratch_;
};
TYPED_TEST_SUITE(LanesRefuse, Designs, DesignNames);

TYPED_TEST(LanesRefuse, InputsWithRules) {
  this->played_.model.machine.legal.push_back({"it is so", nets::yes});
  EXPECT_EQ(this->why(this->machine_.second),
            "it: does not run in lanes: its inputs have rules, and inputs that break one are drawn "
            "again, case by case");
}

TYPED_TEST(LanesRefuse, AStateThatIsTooLarge) {
  auto& state = this->played_.model.machine.state;
  const nets::Wire word{state.front().field, std::vector<nets::Bit>(64, nets::no), {}};
  std::size_t bits = 0;
  for (const nets::Wire& w : state) bits += w.code.size();
  for (; bits <= 16384; bits += 64) state.push_back(word);
  EXPECT_EQ(this->why(this->machine_.second),
            "it: does not run in lanes: its memory is too large: " + std::to_string(bits) +
                " bits, and 16384 can be planes");
}

TYPED_TEST(LanesRefuse, RtlThatChecksItself) {
  const std::string checks =
      "it: does not run in lanes: its RTL checks itself, with an assertion "
      "or $error";
  EXPECT_EQ(this->why(this->with("module m; initial $error(\"no\"); endmodule")), checks);
  EXPECT_EQ(this->why(this->with("module m; initial $fatal; endmodule")), checks);
  EXPECT_EQ(this->why(this->with("module m(input c); assert property (c); endmodule")), checks);
}

// A comment says nothing, nor does a name that has the word in it: refused for something else.
TYPED_TEST(LanesRefuse, NothingForAWordInAComment) {
  auto& state = this->played_.model.machine.state;
  const nets::Wire word{state.front().field, std::vector<nets::Bit>(16384, nets::no), {}};
  state.push_back(word);
  const auto source =
      this->with("// assert $error\n/* $fatal\n * assert */\nmodule m; wire asserted; endmodule");
  EXPECT_NE(this->why(source).find("its memory is too large"), std::string::npos);
}

}  // namespace
}  // namespace cosim::test
