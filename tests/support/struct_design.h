// Structs as a design, one for each shape, for tests without CMake and without an exporter.
#pragma once

#include <array>

#include "model/clocked/design.h"
#include "model/clocked/model.h"

namespace cosim::test {

/// What CMake would say of them.
template <class First, class... More>
struct StructSays {
  static constexpr const char* name = First::name;
  static constexpr std::array<std::array<Parameter, 0>, 1 + sizeof...(More)> parameters{};
  static constexpr std::array<const char*, 1 + sizeof...(More)> files{};
};

/// The design; its Params are the number of a shape.
template <class... Shapes>
using StructDesign = clocked::DesignOf<StructSays<Shapes...>, Shapes...>;

}  // namespace cosim::test
