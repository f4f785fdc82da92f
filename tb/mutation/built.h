// The program that attacks the mutants of all shapes that are built.
#pragma once

#include "tb/mutation/cases.h"

namespace cosim::mutation {

/// main() of the program that CMake makes of all designs, whose --help says what it takes. `cases`:
/// what each bench is attacked with.
int main_of_built(Cases (*cases)(const AnyBench&), int argc, char** argv);

}  // namespace cosim::mutation
