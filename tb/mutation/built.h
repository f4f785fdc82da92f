// The mutants of a shape that is built, of a model in lockstep: attacked in lanes.
#pragma once

#include "tb/mutation/cases.h"

namespace cosim::mutation {

/// main() of the program that CMake makes of all designs. `cases`: what each bench is attacked
/// with.
///   PROGRAM SHAPE COUNT [WORD...]          as main_of(), on at most COUNT mutants of "NAME M=5
///   N=2" PROGRAM SHAPE COUNT --verilog FILE     writes RTL that has them PROGRAM SHAPE COUNT
///   --draw N FOLDER    draws N of them that lanes kill, see drawn.h
int main_of_built(Cases (*cases)(const AnyBench&), int argc, char** argv);

}  // namespace cosim::mutation
