// Results of sweeps as JSON, for what goes on later or elsewhere.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tb/sweep/result.h"

namespace cosim::cli {

/// All but the first failure.
nlohmann::json to_json(const Result& result);

/// From that. InputError, or an exception of the library, where it is none.
Result result_from(const nlohmann::json& json);

}  // namespace cosim::cli
