// The adapter that finds nets by name, on the circular RTL: it drives and reads what the other one
// does, and refuses tables that are not the RTL's.
#include "tb/dut/named_adapter.h"

#include <VcircularW4_ports.h>
#include <gtest/gtest.h>

#include <functional>

#include "model/core/input_error.h"
#include "tb/sim/design_bench.h"
#include "tb/util/random.h"
#include "tests/designs/circular/records.h"
#include "tests/support/error_of.h"

namespace cosim::circular {
namespace {

struct Trait {
  using Design = circular::Design;
  static constexpr Params params = of_width(4);
  static constexpr const char* title = "circular W=4";
  static constexpr const char* clock = "clk";
  static constexpr const char* registers = "";
};
using Named = NamedAdapter<VcircularW4, Trait>;

TEST(NamedAdapter, IsInLockstep) {
  const DesignBench<Design> bench(dut_maker<Named>());
  for (std::uint64_t i = 0; i < 20; ++i) {
    const auto run = bench.run_hostile({1, i, 1000});
    ASSERT_FALSE(run.mismatch) << to_text(*run.mismatch);
    EXPECT_EQ(run.clocks, 1000U);
  }
}

// An adapter of an instance that nobody used: it has all that were used before.
class Fresh {
 public:
  explicit Fresh(std::uint32_t power_up) {
    while (auto one = SpareInstances<VcircularW4>::instance().take())
      used_.push_back(std::move(one));
    adapter_ = std::make_unique<Named>(power_up);
  }
  Named& operator*() { return *adapter_; }

 private:
  std::vector<std::unique_ptr<cosim::Instance<VcircularW4>>> used_;
  std::unique_ptr<Named> adapter_;
};

// No reset: from power-up on, the registers too.
TEST(NamedAdapter, OneThatWasUsedIsWhatANewOneIs) {
  for (std::uint32_t power_up = 1; power_up <= 10; ++power_up) {
    Fresh new_one(power_up);
    Named& fresh = *new_one;
    {
      Named used(power_up + 1);
      for (const bool clk : {false, true, false}) used.eval(clk);
    }
    Named kept(power_up);
    ASSERT_FALSE(SpareInstances<VcircularW4>::instance().take()) << "it is the one that was used";
    Random random(power_up);
    for (int c = 0; c < 50; ++c) {
      Words<Inputs<Word>> in;
      for (std::size_t i = 0; i < in.size(); ++i) {
        in[i] = random.corner(Inputs<Word>::fields(Trait::params)[i].width);
      }
      for (const bool clk : {false, true}) {
        for (Named* one : {&kept, &fresh}) {
          one->drive(from_words<Inputs<Word>>(in));
          one->eval(clk);
        }
        ASSERT_EQ(to_words(kept.outputs()), to_words(fresh.outputs())) << power_up << ' ' << c;
        ASSERT_EQ(to_words(kept.registers()), to_words(fresh.registers())) << power_up << ' ' << c;
      }
    }
  }
}

TEST(NamedAdapter, IsOfTheShapeThatItsModelNames) {
  const DesignBench<Design> bench(dut_maker<Named>());
  require_shape(bench, Trait::title);
  for (const char* other : {"circular W=8", "circular", "arc W=4", "circular V=4"}) {
    EXPECT_THROW(require_shape(bench, other), InputError) << other;
  }
}

class Instance : public VerilatedInstance<VcircularW4> {
 public:
  Instance() : VerilatedInstance(1) {}
  using VerilatedInstance::context, VerilatedInstance::top;
};

Ports whole() {
  const auto in = Inputs<Word>::fields(Trait::params);
  const auto out = Outputs<Word>::fields(Trait::params);
  return {"circular W=4", "clk", {in.begin(), in.end()}, {out.begin(), out.end()}};
}

// That is said of tables that `change` has made wrong.
void expect_said(const std::string& said, const std::function<void(Ports&)>& change) {
  Instance instance;
  Ports ports = whole();
  change(ports);
  EXPECT_EQ(test::error_of([&] { find_ports(ports_of(instance.top()), ports); }),
            said.empty() ? "" : "circular W=4: " + said);
}

TEST(Ports, AreThoseOfTheTables) {
  expect_said("", [](Ports&) {});
  expect_said("the RTL has an input stop that the model does not have",
              [](Ports& p) { p.inputs.pop_back(); });
  expect_said("the RTL has an output step_x that the model does not have",
              [](Ports& p) { p.outputs.pop_back(); });
  expect_said("input lode: the RTL has no such port", [](Ports& p) { p.inputs[1].net = "lode"; });
  expect_said("input f: 5 bits in the model, 6 in the RTL",
              [](Ports& p) { p.inputs[2].width = 5; });
  expect_said("input running: in the RTL it is no input",
              [](Ports& p) { p.inputs[0].net = "running"; });
  expect_said("input f: no field has its bit 5", [](Ports& p) {
    p.inputs[2].net = "f[4:0]";
    p.inputs[2].width = 5;
  });
  expect_said("input f: two fields have bit 0", [](Ports& p) { p.inputs.push_back(p.inputs[2]); });
  expect_said("clock clock: the RTL has no such port", [](Ports& p) { p.clock = "clock"; });
}

// What is said of a register, behind the design and the register.
std::string refusal_of_register(const char* net, int width) {
  Instance instance;
  Field field = Registers<Word>::fields(Trait::params)[0];
  field.net = net;
  field.width = width;
  const std::string head = std::string("circular W=4: register ") + net + ": ";
  const std::string said = test::error_of([&] {
    find_registers(instance.context(), "circular W=4", {&field, 1});
  });
  return said.starts_with(head) ? said.substr(head.size()) : said;
}

TEST(Register, AllThatAreNotThereAreSaidAtOnce) {
  Instance instance;
  const auto fields = Registers<Word>::fields(Trait::params);
  Field some[] = {fields[0], fields[1]};
  some[0].net = "none";
  some[1].net = "other.one";
  const std::string error =
      test::error_of([&] { find_registers(instance.context(), "circular W=4", some); });
  EXPECT_EQ(error,
            "circular W=4: register none: the RTL has no such net; register other.one: the "
            "RTL has no such net");
}

TEST(Register, IsFoundByItsPath) {
  EXPECT_EQ(refusal_of_register("t4_q", 1), "");
  EXPECT_EQ(refusal_of_register("t5_q", 1), "the RTL has no such net");
  EXPECT_EQ(refusal_of_register("block1.f_q", 1), "the RTL has no such net");
  EXPECT_EQ(refusal_of_register("t4_q[0]", 1), "");
  EXPECT_EQ(refusal_of_register("t4_q[1]", 1), "the RTL has bits 0 to 0");
  EXPECT_EQ(refusal_of_register("t4_q", 2), "2 bits in the model, 1 in the RTL");
}

}  // namespace
}  // namespace cosim::circular
