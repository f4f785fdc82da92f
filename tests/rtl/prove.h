// The proof on RTL that is not what the program was built from: a variant's.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include "tb/proof/decide.h"
#include "tb/proof/machines.h"
#include "tb/support/process.h"
#include "tests/rtl/variant.h"

namespace cosim::test {

constexpr int kLimit = 60;  // seconds for one answer

inline bool can_prove() {
  for (const char* program : {"yosys", "cvc5", "z3"}) {
    if (run_program({program, "--version"}).status == 127) return false;
  }
  return true;
}

/// The files of variants/<design>/<name>, as CMake made them.
inline proof::Rtl rtl_of(const std::string& design, const std::string& name,
                         const AnyBench& bench) {
  std::string id = design + '_' + name;
  std::replace(id.begin(), id.end(), '/', '_');
  return proof::Rtl(
      proof::source_in(std::filesystem::path(COSIM_VARIANTS) / id, design, bench.parameters()));
}

}  // namespace cosim::test
