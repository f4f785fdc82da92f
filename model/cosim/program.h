// What a model reads that runs test programs: ELF files, and memory.
#pragma once

#include "model/core/program.h"
