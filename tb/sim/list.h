// The list of all benches.
#pragma once

#include <memory>
#include <vector>

namespace cosim {

class AnyBench;

/// Every bench that was built, in the order of rtl/shipped.txt.
const std::vector<std::unique_ptr<AnyBench>>& benches();

/// Adds the benches of one design.
using AddBenches = void (*)(std::vector<std::unique_ptr<AnyBench>>& all);
/// What these add, up to a null: the list of a program, made once.
const std::vector<std::unique_ptr<AnyBench>>& benches_by(const AddBenches* add);

}  // namespace cosim
