// Results of sweeps as JSON, for what goes on later or elsewhere.
#pragma once

#include "tb/support/json_fwd.h"
#include "tb/sweep/result.h"

namespace cosim::cli {

/// All but the first failure.
Json to_json(const Result& result);

/// From that. InputError, or an exception of the library, where it is none.
Result result_from(const Json& json);

}  // namespace cosim::cli
