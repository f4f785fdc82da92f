// The option --code of a line, for machines of several widths.
#include "model/linear/control_code.h"
#include "tb/designs/linear/cli/code_option.h"
#include "tests/fuzz/expect.h"

namespace cosim::fuzz {

FUZZ_TARGET(codes) {
  for (const int m : {2, 5, 16, 32}) {
    const std::int64_t major = (std::int64_t{1} << m) - 1;
    cli::ChosenCode chosen;
    if (!accepted("--code: ", [&] { chosen = cli::choose_code(text, m, major, major / 3); })) {
      continue;
    }
    expect(chosen.code >> m == 0, "the code fits the machine");
    expect(linear::minor_steps(m, major, chosen.code) == major / 3, "it gives the minor steps");
  }
}

}  // namespace cosim::fuzz
