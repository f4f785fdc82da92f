// The option --code of a line: the control code UK, chosen or by rule.
#pragma once

#include <optional>
#include <string>

#include "model/linear/control_code.h"
#include "tb/cli/command.h"

namespace cosim::cli {

/// A code and the minor steps it gives.
struct ChosenCode {
  linear::Code code = 0;
  std::int64_t minor = 0;
  std::string rule;  ///< "best", "greedy", or empty where the person gave the code itself
};

/// UK as --code says: best (the default), greedy, the m bits, or 0x and the number they stand for.
/// `minor` may be absent where the code itself is given. InputError where the code is none of
/// these, does not have m bits, or does not give `minor` steps.
ChosenCode choose_code(const Text& code, int m, std::int64_t major,
                       std::optional<std::int64_t> minor);

/// How wide a machine the bits of a code are for; none where it is a rule or a number.
std::optional<int> width_of(const Text& code);

/// The rule of that name, best where there is none. InputError for another name.
linear::Code (*code_rule(const Text& code))(int m, std::int64_t major, std::int64_t minor);

}  // namespace cosim::cli
