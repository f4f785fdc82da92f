// What a sweep keeps in memory.
#pragma once

#include <gtest/gtest.h>

#include "tests/cli/program.h"
#include "tests/support/sanitized.h"

namespace cosim::cli {

/// cosim sweep with these words takes no more memory for more cases: what is kept of a case, were
/// it 100 bytes, would show.
inline void expect_no_more_memory(Arguments machine) {
  machine.insert(machine.begin(), "sweep");
  const auto peak = [&](const std::string& cases) {
    Arguments words = machine;
    words.insert(words.end(), {"--jobs", "1", "--random", cases});
    const Ended ended = ends(0, cosim(words));
    return ended.peak;
  };
  constexpr long noise = (1 << 20) + test::kept_back;
  EXPECT_LT(peak("20000"), peak("10") + noise) << machine[1];
}

}  // namespace cosim::cli
