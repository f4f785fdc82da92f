// The checkpoint "state" of a sweep in a folder.
#pragma once

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/cli/folder.h"
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

/// A checkpoint whose hash is that of its state, 64 bits of FNV-1a: what was changed in it is taken
/// for what the program kept.
inline std::string sealed(nlohmann::json file) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : file["state"].dump()) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  file["hash"] = text;
  return file.dump();
}

}  // namespace cosim::cli
