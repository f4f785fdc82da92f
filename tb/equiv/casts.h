// Casts to a size, as 5'(x), which yosys 0.23 misreads behind an operator of one operand.
#pragma once

#include <string>

namespace cosim::equiv {

/// A text of SystemVerilog with brackets around each cast to a size behind an operator: yosys reads
/// |5'(x) as (|5)'(x), but |(5'(x)) as it is written. Text in comments and strings stays as it is.
std::string with_casts_apart(const std::string& text);

}  // namespace cosim::equiv
