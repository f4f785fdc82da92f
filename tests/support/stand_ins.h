// Programs in place of others, as $PATH has them.
#pragma once

#include "tests/support/folder.h"

namespace cosim::test {

/// $PATH is that for as long as it lives.
class WithPath {
 public:
  explicit WithPath(const std::string& path) { setenv("PATH", path.c_str(), 1); }
  ~WithPath() { setenv("PATH", before.c_str(), 1); }
  WithPath(const WithPath&) = delete;
  WithPath& operator=(const WithPath&) = delete;

  const std::string before = std::getenv("PATH");
};

/// Programs of a test's own, found before all others of their names.
class StandIns {
 public:
  void program(const std::string& name, const std::string& script) const {
    std::filesystem::permissions(folder.write(name, "#!/bin/sh\n" + script + '\n'),
                                 std::filesystem::perms::owner_all);
  }
  const Folder folder;
  const WithPath path{folder.path("") + ':' + std::getenv("PATH")};
};

}  // namespace cosim::test
