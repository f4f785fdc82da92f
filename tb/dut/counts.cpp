#include "tb/dut/counts.h"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

namespace cosim::coverage {

std::string file_for(const std::string& what, int number) {
  const char* folder = std::getenv("COSIM_COVERAGE");
  if (folder == nullptr || *folder == '\0') return {};
  return fmt::format("{}/{}.{}.{}", folder, what, getpid(), number);
}

void leave(const std::string& what, const std::string& design, const std::vector<Count>& counts) {
  const std::string path = file_for(what, 0);
  if (path.empty()) return;
  std::ofstream file(path, std::ios::app);
  for (const Count& count : counts) {
    file << fmt::format("{}\t{}\t{}\n", design, count.name, count.hits);
  }
}

}  // namespace cosim::coverage
