// What is known of a bench's RTL and of its model.
#pragma once

#include <string>

#include "tb/proof/claims.h"
#include "tb/proof/machines.h"
#include "tb/sim/bench.h"

namespace cosim::cli {

/// What is known of a bench's RTL and of its model. InputError where nothing is.
const proof::BuiltMachine& machine_of(const AnyBench& bench);

/// The bench of a title; there is one.
const AnyBench& bench_of(const std::string& title);

/// The RTL that a bench was built from, with its parameters.
proof::Source source_of(const AnyBench& bench);

/// RTL as it is read for claims on a model, which decides which of the RTL's registers are kept and
/// how it is reset.
proof::Source source_for(const nets::Model& model, proof::Source source);

}  // namespace cosim::cli
