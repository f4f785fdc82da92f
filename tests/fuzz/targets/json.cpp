// What the program reads back as JSON: each value is what it is taken for, or is refused by its
// place.
#include "tb/util/json.h"

#include "tb/util/json_at.h"
#include "tests/fuzz/expect.h"

namespace cosim::fuzz {
namespace {

const std::string file = "x.json";

// Every value as each kind: it is of one of them, or null.
void check(const JsonAt& at) {
  int kinds = at.json().is_null() ? 1 : 0;
  kinds += accepted(file, [&] { at.text(); }) ? 1 : 0;
  kinds += accepted(file, [&] { at.yes(); }) ? 1 : 0;
  kinds += accepted(file, [&] { at.number(-1e308, 1e308); }) ? 1 : 0;
  kinds += accepted(file,
                    [&] {
                      for (const JsonAt& one : at.list()) check(one);
                    })
               ? 1
               : 0;
  kinds += accepted(file, [&] { at.find(""); }) ? 1 : 0;
  const bool huge = at.json().is_number_float();  // beyond the range above
  expect(kinds == 1 || huge, "a value is of one kind");
  accepted(file, [&] { expect(at.whole(3, 9) >= 3, "the number is in its range"); });
  if (!at.json().is_object()) return;
  for (const auto& item : at.json().items()) {
    check(at.at(item.key()));
    accepted(file, [&] { at.at(item.key() + 'x'); });
  }
}

}  // namespace

FUZZ_TARGET(json) {
  accepted(file, [&] {
    const JsonAt all(file, text);
    check(all);
    std::vector<std::string> errors;
    const bool same = parse_json(json_text(all.json()), errors) == all.json() && errors.empty();
    expect(same, "it comes back from its text");
  });
}

}  // namespace cosim::fuzz
