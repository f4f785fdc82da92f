#include "tb/cli/registry.h"

#include <algorithm>
#include <filesystem>

#include "model/core/input_error.h"
#include "tb/cli/built.h"
#include "tb/util/build_targets.h"

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

const OnDemand& on_demand(const std::vector<OnDemand>& all, const std::string& title) {
  const auto found = std::ranges::find(all, title, &OnDemand::title);
  if (found == all.end()) throw InputError(title + ": there is no such program for it");
  return *found;
}

void build(const Registry& registry, const std::vector<OnDemand>& programs) {
  std::vector<std::string> targets;
  for (const OnDemand& program : programs) targets.push_back(program.target);
  build_targets(registry.cmake(), registry.build_folder(), targets);
}

std::string path_of(const OnDemand& program) {
  return (std::filesystem::path(program.folder) / program.target).string();
}

}  // namespace cosim::cli
