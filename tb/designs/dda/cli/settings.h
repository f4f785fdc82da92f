// The options that say how a DDA is run.
#pragma once

#include "model/dda/curve.h"
#include "tb/program/command.h"

namespace cosim::cli {

struct DdaSettings {
  Text update, preload;
  bool as_it_is = false;

  void add(const Command& command);
  /// InputError for a name that is none.
  dda::Settings parse() const;
};

}  // namespace cosim::cli
