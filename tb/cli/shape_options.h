// The options that name a machine's shape.
#pragma once

#include "tb/cli/choose.h"
#include "tb/cli/command.h"

namespace cosim::cli {

struct ShapeOptions {
  Text m, n, width;

  /// `otherwise`: what is taken where they are not given, for the help.
  void add_linear(const Command& command, const std::string& otherwise = smallest);
  void add_circular(const Command& command, const std::string& otherwise = smallest);
  void add_dda(const Command& command, const std::string& otherwise = smallest);
  LinearShape linear() const;
  CircularShape circular() const;
  DdaShape dda() const;

  static constexpr const char* smallest = "the smallest that holds it";
};

}  // namespace cosim::cli
