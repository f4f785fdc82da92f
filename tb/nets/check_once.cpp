#include "tb/nets/check_once.h"

#include <filesystem>

#include "model/core/input_error.h"
#include "tb/util/hash.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"

namespace cosim::nets {

namespace fs = std::filesystem;

void check_once(const std::string& file, const std::string& name,
                const std::function<void()>& check) {
  std::string made_of = program_hash();
  for (const char* part : {".btor2", ".driver.btor2", ".checker.btor2"}) {
    if (fs::exists(file + part)) made_of += hash_of_file(file + part);
  }
  const std::string hash = hash_of(made_of) + '\n';
  const std::string kept =
      file + '.' + name + '.' + fs::read_symlink("/proc/self/exe").filename().string();
  if (fs::exists(kept) && read_file(kept) == hash) return;
  check();
  try {
    write_file(kept, hash);
  } catch (const InputError&) {
    // In a build folder of somebody else it is checked each time.
  }
}

}  // namespace cosim::nets
