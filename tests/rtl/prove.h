// The proof on RTL that is not what the program was built from: a variant's.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include "tb/proof/decide.h"
#include "tb/proof/machines.h"
#include "tests/rtl/variant.h"
#include "tests/support/solvers.h"

namespace cosim::test {

/// The files of variants/<design>/<name>, as CMake made them.
inline proof::Source source_of(const std::string& design, const std::string& name,
                               const AnyBench& bench) {
  std::string id = design + '_' + name;
  std::replace(id.begin(), id.end(), '/', '_');
  return proof::source_in(std::filesystem::path(COSIM_VARIANTS) / id, design, bench.parameters());
}

}  // namespace cosim::test
