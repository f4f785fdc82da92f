// Two RTLs of a few lines for `cosim equiv`, and what is expected of them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"

namespace cosim::cli {

// `body` behind a clock, a reset and `ports`.
inline std::string module_of(const std::string& ports, const std::string& body) {
  return "module m(input clk, input rst" + ports + ");\n" + body + "\nendmodule\n";
}

inline Ended equiv(const std::string& gold, const std::string& gate, const Arguments& more = {},
                   const std::string& top = "m") {
  const Folder folder;
  const Ended ended =
      cosim(joined({"equiv", "--gold", folder.write("gold.v", gold), "--gate",
                    folder.write("gate.v", gate), "--top", top, "--failures", folder.path("kept")},
                   more));
  // What is kept belongs to a difference alone.
  EXPECT_EQ(folder.holds("kept"), ended.status == 1) << ended.out;
  return ended;
}

/// The comparison ends with the status and says that.
inline void expect_said(int status, const std::string& gold, const std::string& gate,
                        const std::string& said, const Arguments& more = {}) {
  const Ended ended = ends(status, equiv(gold, gate, more));
  EXPECT_NE(ended.out.find(said), std::string::npos) << ended.out;
}

inline void expect_equal(const std::string& gold, const std::string& gate,
                         const Arguments& more = {}) {
  expect_said(0, gold, gate, "m: equal for ever", more);
}

inline void expect_different(const std::string& gold, const std::string& gate,
                             const std::string& said, const Arguments& more = {}) {
  expect_said(1, gold, gate, said, joined({"--netlists"}, more));
}

inline void expect_refused(const Ended& ended, const std::string& said) {
  EXPECT_EQ(ended.status, 2) << ended.out;
  EXPECT_EQ(lines(ended.err).size(), 1U) << ended.err;
  EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
}

}  // namespace cosim::cli
