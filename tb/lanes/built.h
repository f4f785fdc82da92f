// A shape's lanes, compiled when they are first asked for and kept.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "tb/lanes/layout.h"

namespace cosim::lanes {

/// How many lanes the processor runs at once with one instruction: 512, 256, or 64 where it has no
/// vectors of these widths.
int widest();

/// Functions as to_text() defines them, in the memory of this process.
class Built {
 public:
  using Act = void (*)(std::uint64_t* planes);
  using Choose = void (*)(std::uint64_t* planes, const std::uint64_t* which,
                          const std::uint64_t* from, std::uint64_t count);
  using Clear = void (*)(std::uint64_t* planes, const std::uint64_t* which, std::uint64_t count);
  using Run = std::int64_t (*)(std::uint64_t* planes, const std::uint64_t* active,
                               std::uint64_t from, std::uint64_t to, std::uint64_t* differ,
                               std::uint64_t* left_out);

  /// Loads a library. InputError where that cannot be done.
  explicit Built(std::filesystem::path from);
  ~Built();
  Built(const Built&) = delete;
  Built& operator=(const Built&) = delete;

  std::filesystem::path library;
  int lanes = 0;
  Layout layout;
  Act reset = nullptr, take_over = nullptr;
  Choose choose = nullptr;
  Clear clear = nullptr;
  Run run = nullptr;

 private:
  void* handle_ = nullptr;
};

/// What the code depends on beside its source, in words: compiler and yosys. InputError where a
/// tool is missing.
std::string tools();

/// The library in `folder` that was made of the same `key`; else compiles what source() gives, for
/// so many lanes, and keeps it. Where this processor has vectors of this width, it runs on any that
/// has them. Of two processes that ask at once, one compiles and the other waits. InputError where
/// there is no compiler or it fails.
std::unique_ptr<Built> built(const std::filesystem::path& folder, const std::string& key, int lanes,
                             const std::function<std::string()>& source);

}  // namespace cosim::lanes
