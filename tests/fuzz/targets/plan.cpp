// A plan: what is read comes back from what a run keeps of it; what is refused is so in lines.
#include "tb/regress/plan.h"

#include "tests/fuzz/expect.h"

namespace cosim::fuzz {
namespace {

using Type = regress::Key::Type;

const std::vector<regress::Keys> kinds{
    {"sweep", {{"sweep", Type::text, ""}, {"cases", Type::number, "", 1, 1 << 20}}},
    {"run", {{"run", Type::words, ""}, {"quiet", Type::yes, ""}}}};

}  // namespace

FUZZ_TARGET(plan) {
  const std::string name = "x.json";
  std::vector<std::string> errors;
  const auto plan = regress::read_plan(text, name, kinds, 7, errors);
  for (const std::string& line : errors) {
    accepted(name, [&] { throw InputError(line); });
  }
  if (!errors.empty()) return;
  accepted(name, [&] {
    const std::string kept = json_text(regress::to_json(plan));
    const auto again = regress::read_plan(kept, name, kinds, 9, errors);
    expect(errors.empty(), "what is kept of a plan is a plan");
    expect(json_text(regress::to_json(again)) == kept, "it comes back");
  });
}

}  // namespace cosim::fuzz
