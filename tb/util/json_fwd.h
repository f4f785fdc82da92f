// JSON with its keys in the order in which they were put, declared: json.h defines it.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace cosim {

using Json = nlohmann::ordered_json;

}  // namespace cosim
