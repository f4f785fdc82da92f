// Verilog, as a front end of yosys makes cells of it.
#pragma once

#include <string>

#include "tb/equiv/side.h"

namespace cosim::equiv {

/// What a front end writes of a design.
struct Elaborated {
  std::string json, rtlil;
  bool has_unique = false;  ///< an incomplete `unique case` is any value in it
};

/// Reads the files. InputError, one line that begins with `what` or a file; OutOfTime.
Elaborated elaborated(const Files& files, const std::string& what, FrontEnd front_end,
                      const Budget& budget);

/// What slang makes of a design, as elaborated().
Elaborated elaborated_by_slang(const Files& files, const std::string& what, const Budget& budget);

/// The design as plain Verilog that yosys 0.23 reads, as slang reads it: its parameters are
/// numbers, its nets and registers have their names. InputError and OutOfTime, as above.
std::string verilog_by_slang(const Files& files, const std::string& what, const Budget& budget);

/// Whether slang is there: `scripts/setup systemverilog` brings it. Another folder of npm's
/// packages, or a yosys that has read_slang, is named by COSIM_SLANG.
bool has_slang();

/// What a message that another front end failed ends with: what installs slang; "" where it is
/// there.
std::string slang_hint();

/// A text of SystemVerilog with brackets around each cast to a size behind an operator: yosys reads
/// |5'(x) as (|5)'(x), but |(5'(x)) as it is written. Text in comments and strings stays as it is.
std::string with_casts_apart(const std::string& text);

/// A text of Verilog, on the same lines, in which an asynchronous reset that is asked together with
/// something else, as in if (!rst_n || clear), is asked first, and the rest behind it: front ends
/// read that alone.
std::string with_resets_apart(std::string text);

}  // namespace cosim::equiv
