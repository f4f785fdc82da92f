// The options that name a machine's shape.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tb/cli/choose.h"

namespace cosim::cli {

struct ShapeOptions {
  std::string m, n, width;  ///< as typed; empty where not given

  void add_linear(CLI::App& command);
  void add_circular(CLI::App& command);
  LinearShape linear() const;
  CircularShape circular() const;
};

}  // namespace cosim::cli
