// What CMake knows of a program. The file that it makes of it reads nothing else.
#pragma once

namespace cosim::cli {

class Registry;

/// An OnDemand of the registry.
struct BuiltOnDemand {
  enum class Kind { full, attacks, cover };
  Kind kind;
  const char *title, *target, *folder;
};

struct BuiltProgram {
  const char *name, *cmake, *build_folder;
  const BuiltOnDemand* on_demand;  ///< up to one that has no target
  void (*const* add)(Registry&);   ///< what designs and studies add, up to null
};

/// Made by CMake, from program.cpp.in.
extern const BuiltProgram built_program;

}  // namespace cosim::cli
