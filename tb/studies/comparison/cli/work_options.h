// The work that cosim compare is asked for: one line, one arc, or all those of a program.
#pragma once

#include <string>

#include "tb/program/command.h"
#include "tb/studies/comparison/work.h"

namespace cosim::cli {

struct WorkOptions {
  Text file, steps_per_mm, line, arc;

  void add(const Command& command);
};

struct NamedWork {
  std::string text;  ///< what it is, one line
  compare::Work pieces;
};

/// InputError where not exactly one is asked for, and where it cannot be read or is too large.
NamedWork parse_work(const WorkOptions& o);

}  // namespace cosim::cli
