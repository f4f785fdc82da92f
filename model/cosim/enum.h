// What a model with an Enum<E, W> reads, a register or an output of W bits whose values have names.
#pragma once

#include "model/clocked/enum.h"
#include "model/cosim/model.h"
