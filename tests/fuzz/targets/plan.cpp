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
}  // namespace cosim::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace cosim;
  const std::string name = "x.json";
  std::vector<std::string> errors;
  const auto plan = regress::read_plan(fuzz::text_of(data, size), name, fuzz::kinds, 7, errors);
  for (const std::string& line : errors) {
    fuzz::accepted(name, [&] { throw InputError(line); });
  }
  if (!errors.empty()) return 0;
  fuzz::accepted(name, [&] {
    const std::string text = json_text(regress::to_json(plan));
    const auto again = regress::read_plan(text, name, fuzz::kinds, 9, errors);
    fuzz::expect(errors.empty(), "what is kept of a plan is a plan");
    fuzz::expect(json_text(regress::to_json(again)) == text, "it comes back");
  });
  return 0;
}
