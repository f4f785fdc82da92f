// The proof refutes every planted fault, and its counterexample is one: in simulation the RTL with
// the fault differs on it and the RTL as shipped does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "tb/proof/counterexample.h"
#include "tests/rtl/prove.h"
#include "tests/support/designs.h"
#include "tests/support/in_lanes.h"

namespace cosim::test {
namespace {

struct Planted {
  std::string design, name, what;
  const AnyBench* bench = nullptr;
  const AnyBench* shipped = nullptr;
  friend void PrintTo(const Planted& s, std::ostream* out) { *out << s.design << ' ' << s.name; }
};

// A handful of all kinds, and with $COSIM_PROVE_ALL every variant there is.
bool wanted(const std::string& variant) {
  static const std::set<std::string> handful = {"deep/tick_carry",
                                                "errata/l2",
                                                "faults/rom11_off_by_one",
                                                "faults/start_without_code",
                                                "errata/c5",
                                                "errata/c10_load",
                                                "faults/variants_swapped",
                                                "faults/load_over_clear",
                                                "errata/d4",
                                                "faults/borrow_missed",
                                                "faults/two_c_for_two_a"};
  if (variant.starts_with("gates/") || variant.starts_with("shipped/")) return false;
  return handful.contains(variant) || std::getenv("COSIM_PROVE_ALL") != nullptr;
}

template <class Design>
void add_subjects(std::vector<Planted>& all) {
  for (const auto& v : variants<Design>()) {
    if (!wanted(v.name)) continue;
    Planted s{Design::name, v.name, v.what, v.bench.get(), nullptr};
    for (const auto& b : benches()) {
      if (b->title() == s.bench->title()) s.shipped = b.get();
    }
    all.push_back(s);
  }
}

std::vector<Planted> subjects() {
  std::vector<Planted> all;
  for_each_design([&]<class Design>() { add_subjects<Design>(all); });
  return all;
}

class Proof : public testing::TestWithParam<Planted> {};
TEST_P(Proof, Refutes) {
  if (!can_prove()) GTEST_SKIP() << "needs yosys";
  const Planted& s = GetParam();
  const auto& machine = *machine_of(*s.bench).first;
  const nets::Model model = machine.nets();
  const auto claims = claims_of(model, source_of(s.design, s.name, *s.bench));
  const proof::Claim &clear = claims[0], &step = claims[1];

  // By both engines, each with a counterexample of its own.
  for (const auto& engines :
       {proof::all_engines(), {proof::Engine::cadical}, {proof::Engine::cec}}) {
    const auto decided = proof::decide({&clear, &step}, {engines, kLimit, 1});
    ASSERT_TRUE(decided[0].refuted || decided[1].refuted)
        << s.what << "\nclear: " << decided[0].verdict << "\nstep: " << decided[1].verdict;
    if (!decided[1].refuted || engines.size() == 2) continue;

    const auto c = proof::counterexample(model, proof::refuting_values(decided[1]));
    ASSERT_TRUE(c);
    const Stimulus stimulus = s.bench->clock_from(proof::words(c->state), proof::words(c->inputs));
    const auto run = s.bench->replay(stimulus);
    ASSERT_TRUE(run.mismatch) << "no counterexample in simulation:\n" << to_text(*c);
    EXPECT_LE(run.mismatch->clock, 1U);
    EXPECT_FALSE(s.shipped->replay(stimulus).mismatch) << "one of good RTL:\n" << to_text(*c);
  }
}
std::string name_of(const testing::TestParamInfo<Planted>& info) {
  std::string name = info.param.design + '_' + info.param.name;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Planted, Proof, testing::ValuesIn(subjects()), name_of);

}  // namespace
}  // namespace cosim::test
