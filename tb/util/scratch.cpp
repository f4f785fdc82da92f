#include "tb/util/scratch.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/util/leftover.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

// Tools of others cannot be given every name of a folder: abc of yosys takes none with a space.
std::string place_for_scratch() {
  const char* folder = std::getenv("TMPDIR");
  const std::string name = folder == nullptr || *folder == 0 ? "/tmp" : folder;
  const bool is_plain = std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("/._-+=,@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return is_plain ? std::filesystem::absolute(name).string() : "/tmp";
}

[[noreturn]] void refuse_for_scratch(int error) {
  throw InputError(fmt::format("{}: no folder for temporary files: {}",
                               one_line(place_for_scratch()), std::strerror(error)));
}

using Root = std::shared_ptr<const std::filesystem::path>;

// For as long as anybody has it.
Root root_of_this_process() {
  static std::mutex guard;
  static std::weak_ptr<const std::filesystem::path> last;
  static pid_t process = 0;
  const std::lock_guard lock(guard);
  Root root = last.lock();
  if (root != nullptr && process == getpid()) return root;
  std::string name = place_for_scratch() + "/cosim.XXXXXX";
  if (mkdtemp(name.data()) == nullptr) refuse_for_scratch(errno);
  const auto leftover = std::make_shared<Leftover>(name);
  root = Root(new std::filesystem::path(name), [leftover](const std::filesystem::path* path) {
    std::error_code ignored;
    std::filesystem::remove_all(*path, ignored);
    delete path;
  });
  last = root;
  process = getpid();
  return root;
}

std::atomic<int> next_number{0};

}  // namespace

void require_room(const std::filesystem::path& folder) {
  constexpr off_t room = 1 << 16;
  const std::string file = folder / ".room";
  const int probe = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  const int error = probe < 0 ? errno : posix_fallocate(probe, 0, room);
  if (probe >= 0) close(probe);
  unlink(file.c_str());
  if (error != ENOSPC && error != EDQUOT) return;
  throw InputError(fmt::format("{}: no room for temporary files: {}", one_line(place_for_scratch()),
                               std::strerror(error)));
}

Scratch::Scratch() : root_(root_of_this_process()), path_(*root_ / std::to_string(next_number++)) {
  if (mkdir(path_.c_str(), 0700) != 0) refuse_for_scratch(errno);
  require_room(path_);
}
Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace cosim
