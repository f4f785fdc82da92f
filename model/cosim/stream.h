// What a model of streams reads.
#pragma once

#include "model/clocked/stream.h"
#include "model/cosim/model.h"
