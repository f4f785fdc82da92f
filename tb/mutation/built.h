// The mutants of a shape that is built.
#pragma once

#include <memory>
#include <string>

#include "tb/mutation/lanes_subject.h"

namespace cosim::mutation {

/// All that its design's jobs.h and hostile clocks give; made by CMake.
Cases cases_of_built(const AnyBench& bench);

/// At most `count` mutants of "NAME M=5 N=2". InputError where it is not built.
std::unique_ptr<LanesSubject> built_subject(const std::string& title, unsigned count);

}  // namespace cosim::mutation
