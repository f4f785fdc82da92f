// In which order straight-line code runs, and which values stay in registers. A clock in lanes
// takes as long as the memory that it touches: planes, and the values that had to leave a register.
#pragma once

#include <cstddef>
#include <vector>

namespace cosim::lanes {

/// A statement of the code: reads values, each named once, and gives at most one. A value that none
/// gives is in memory from the beginning on.
struct Statement {
  static constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> reads;
  std::size_t gives = none;          ///< none: the code is there for what the statement does
  std::vector<std::size_t> after{};  ///< statements that have to be over
};

/// What is to be done next.
struct Move {
  enum class What {
    run,    ///< statement number `of`; what it reads is in registers
    load,   ///< value `of` into a register, from its place or, none, where it was at the beginning
    leave,  ///< the next statement is the last one that finds value `of` in a register; into its
            ///< place first or, none, it is in memory already
  };
  What what = What::run;
  std::size_t of = 0;
  std::size_t place = Statement::none;
};

struct Schedule {
  std::vector<Move> moves;
  std::size_t places = 0;  ///< of the values that left
};

/// All statements, for so many registers, 4 or more. Values are numbered 0 .. values - 1. The same
/// for the same statements.
Schedule scheduled(const std::vector<Statement>& statements, std::size_t values,
                   std::size_t registers);

}  // namespace cosim::lanes
