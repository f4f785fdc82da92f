// The checkpoint "state" of a sweep in a folder.
#pragma once

#include <chrono>
#include <csignal>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "tb/util/hash.h"
#include "tests/cli/program.h"

namespace cosim::cli {

/// The cases that it holds; 0 where there is none.
inline std::uint64_t cases_kept(const Folder& folder) {
  std::uint64_t sum = 0;
  if (!folder.holds("state")) return sum;
  const auto file = nlohmann::json::parse(folder.text("state"));
  for (const auto& one : file["state"]) sum += one["cases"].get<std::uint64_t>();
  return sum;
}

/// The program as shipped, killed so long after "state" has more than `done` cases, where it has
/// not ended by then: whether it was.
inline bool killed_beyond(std::uint64_t done, const Folder& folder, const Arguments& arguments,
                          std::chrono::milliseconds later = {}) {
  const auto has_more = [&] {
    const bool more = cases_kept(folder) > done;
    if (more) std::this_thread::sleep_for(later);
    return more;
  };
  return cosim_signalled(arguments, SIGKILL, has_more).status == 128 + SIGKILL;
}

/// A checkpoint whose hash is that of its state: what was changed in it is taken for what the
/// program kept.
inline std::string sealed(nlohmann::json file) {
  file["hash"] = hash_of(file["state"].dump());
  return file.dump();
}

}  // namespace cosim::cli
