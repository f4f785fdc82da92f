#include "tb/support/scratch.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "model/core/input_error.h"
#include "tb/support/words.h"

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

// The folder that all others of this process lie in. Where this process is killed a shell removes
// it: that waits for the end of a pipe which this process, and the guards of what it runs, hold
// open.
class Scratch::Root {
 public:
  Root() {
    std::uint64_t number = 0;
    if (getrandom(&number, sizeof number, 0) != sizeof number) refuse_for_scratch(errno);
    path = fmt::format("{}/cosim.{:016x}", place_for_scratch(), number);
    // There is no moment when nobody would remove the folder.
    int error = watch();
    if (error == 0 && mkdir(path.c_str(), 0700) != 0) {
      error = errno;
      end_watch();
    }
    if (error != 0) refuse_for_scratch(error);
  }
  ~Root() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
    end_watch();
  }
  /// That of this process, for as long as anybody has it.
  static std::shared_ptr<Root> of_this_process() {
    static std::mutex guard;
    static std::weak_ptr<Root> last;
    const std::lock_guard lock(guard);
    std::shared_ptr<Root> root = last.lock();
    if (root == nullptr || root->process_ != getpid()) last = root = std::make_shared<Root>();
    return root;
  }

  std::string path;
  int held = -1;
  std::atomic<int> folders{0};

 private:
  void end_watch() const {
    kill(watcher_, SIGKILL);
    while (waitpid(watcher_, nullptr, 0) < 0 && errno == EINTR) continue;
    close(held);
  }
  // In a session of its own: what ends a terminal, or all in it, does not end the shell.
  int watch() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return errno;
    held = ends[1];
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[0], STDIN_FILENO);
    for (const int out : {STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_addopen(&files, out, "/dev/null", O_WRONLY, 0);
    }
    posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETSID);
    std::vector<std::string> words{"sh", "-c",
                                   "trap '' HUP INT TERM; read _; exec rm -rf -- \"$0\"", path};
    char* const argv[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                          nullptr};
    const int error = posix_spawn(&watcher_, "/bin/sh", &files, &how, argv, environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    close(ends[0]);
    if (error != 0) close(held);
    return error;
  }

  pid_t process_ = getpid(), watcher_ = -1;
};

Scratch::Scratch()
    : root_(Root::of_this_process()), path_(fmt::format("{}/{}", root_->path, root_->folders++)) {
  if (mkdir(path_.c_str(), 0700) != 0) refuse_for_scratch(errno);
  require_room(path_);
}
Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}
int Scratch::held() const { return root_->held; }

}  // namespace cosim
