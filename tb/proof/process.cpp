#include "tb/proof/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "model/core/input_error.h"

namespace cosim::proof {
namespace {

[[noreturn]] void become(const std::vector<std::string>& words, int out) {
  std::vector<char*> argv;
  for (const std::string& w : words) argv.push_back(const_cast<char*>(w.c_str()));
  argv.push_back(nullptr);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  execvp(argv.front(), argv.data());
  _exit(127);
}

}  // namespace

Ended run_program(const std::vector<std::string>& words) {
  int ends[2] = {-1, -1};
  const pid_t child = pipe2(ends, O_CLOEXEC) == 0 ? fork() : -1;
  if (child < 0) throw InputError(words.front() + ": cannot be run: " + std::strerror(errno));
  if (child == 0) become(words, ends[1]);
  close(ends[1]);
  Ended ended;
  std::string part(1 << 16, '\0');
  for (ssize_t n = 0; (n = read(ends[0], part.data(), part.size())) != 0;) {
    if (n > 0) ended.text.append(part, 0, static_cast<std::size_t>(n));
    if (n < 0 && errno != EINTR) break;
  }
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ended.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return ended;
}

Scratch::Scratch() {
  const char* folder = std::getenv("TMPDIR");
  std::string name = std::string(folder != nullptr ? folder : "/tmp") + "/cosim.XXXXXX";
  if (mkdtemp(name.data()) == nullptr) {
    throw InputError(name + ": cannot be made: " + std::strerror(errno));
  }
  path_ = name;
}
Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace cosim::proof
