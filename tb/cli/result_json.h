// Results of sweeps as JSON, for what goes on later or elsewhere.
#pragma once

#include "tb/sim/bench.h"
#include "tb/sim/result.h"
#include "tb/util/json_at.h"

namespace cosim::cli {

/// All but the first failure.
Json to_json(const Result& result);

/// From that, of cases on this bench. InputError where it is none.
Result result_from(const JsonAt& json, const AnyBench& bench);

}  // namespace cosim::cli
