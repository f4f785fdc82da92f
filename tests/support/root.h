// Where the project's files are.
#pragma once

#include <filesystem>

namespace cosim::test {

inline std::filesystem::path project_root() {
  return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path();
}

}  // namespace cosim::test
