// Two RTLs of a few lines for `cosim equiv`, and what is expected of them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/cli/program.h"
#include "tests/support/stand_ins.h"

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

/// What `compare` gives where there is no solver, no Verilator and nothing else.
inline Ended with_yosys_alone(const std::function<Ended()>& compare,
                              const std::vector<std::string>& more = {}) {
  const Folder bin;
  std::vector<std::string> programs{"env", "yosys", "yosys-abc"};
  programs.insert(programs.end(), more.begin(), more.end());
  for (const std::string& program : programs) {
    const std::string link = "ln -s \"$(command -v " + program + ")\" '" + bin.path(program) + "'";
    EXPECT_EQ(std::system(link.c_str()), 0);
  }
  const test::WithPath alone(bin.path(""));
  return compare();
}

/// The comparison ends with the status and says that.
inline void expect_said(int status, const std::string& gold, const std::string& gate,
                        const std::string& said, const Arguments& more = {}) {
  const Ended ended = ends(status, equiv(gold, gate, more));
  EXPECT_TRUE(has(ended.out, said));
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
  EXPECT_TRUE(has(refusal(ended), said));
}

}  // namespace cosim::cli
