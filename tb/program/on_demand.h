// Programs that are built when a command needs them.
#pragma once

#include <string>
#include <vector>

#include "tb/bench/bench.h"
#include "tb/program/registry.h"

namespace cosim::cli {

/// That of the title. InputError where there is none.
const OnDemand& on_demand(const std::vector<OnDemand>& all, const std::string& title);

/// Builds them at once. InputError where that fails, with what was said on standard error.
void build(const Registry& registry, const std::vector<OnDemand>& programs);

/// Where it is then.
std::string path_of(const OnDemand& program);

}  // namespace cosim::cli
