// What is compared: lines and arcs, each where it lies.
#pragma once

#include "tb/studies/comparison/figures.h"
#include "tb/studies/toolpath/pieces.h"

namespace cosim::compare {

using pieces::Batch;
using pieces::Place;
using pieces::Work;
using pieces::work_of;

}  // namespace cosim::compare
