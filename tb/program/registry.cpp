#include "tb/program/registry.h"

#include "tb/program/built.h"

namespace cosim::cli {

const Registry& registry() {
  static const auto all = [] {
    Registry registry(built_program.name);
    registry.builds(built_program.cmake, built_program.build_folder);
    for (const BuiltOnDemand* one = built_program.on_demand; one->target != nullptr; ++one) {
      const OnDemand program{one->title, one->target, one->folder};
      switch (one->kind) {
        case BuiltOnDemand::Kind::full:
          registry.full(program);
          break;
        case BuiltOnDemand::Kind::attacks:
          registry.attacks(program);
          break;
        case BuiltOnDemand::Kind::cover:
          registry.cover(program);
          break;
      }
    }
    for (auto add = built_program.add; *add != nullptr; ++add) (*add)(registry);
    return registry;
  }();
  return all;
}

}  // namespace cosim::cli
