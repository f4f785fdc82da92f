// What a golden model reads: the words that it is written with stand in model/clocked/model.h.
#pragma once

#include "model/clocked/model.h"

using namespace cosim::clocked;  // NOLINT: for a header that is a model, and nothing else
