// The kinds of task that a regression may have, a file each.
#pragma once

#include <memory>

#include "tb/cli/registry.h"
#include "tb/regress/work.h"

namespace cosim::cli {

std::unique_ptr<regress::Kind> sweep_kind(const Registry& registry);
std::unique_ptr<regress::Kind> prove_kind();
std::unique_ptr<regress::Kind> mutate_kind(const Registry& registry);
std::unique_ptr<regress::Kind> fuzz_kind();
std::unique_ptr<regress::Kind> run_kind();

/// All of them.
regress::Kinds regress_kinds(const Registry& registry);

/// What a task names, a file or a folder, copied from `plan` into the folder `run`; the path there,
/// from `run`. InputError "KEY: ..." where it is not there.
std::string kept_with(const std::string& key, const std::string& path,
                      const std::filesystem::path& plan, const std::filesystem::path& run);

}  // namespace cosim::cli
