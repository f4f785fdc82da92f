#include "tb/cli/outputs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "model/core/input_error.h"
#include "tb/plot/plot.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

// Devices and pipes lose nothing by being written twice.
bool is_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::exists(a, error) || fs::exists(b, error)) {
    return is_file(a) && is_file(b) && fs::equivalent(a, b, error) && !error;
  }
  const auto place = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(path, error), error);
  };
  const fs::path first = place(a);
  return first == place(b) && !error;
}

// Opens it as the report will be opened, but changes nothing.
void check_writable(const std::string& path) {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  const bool absent = type == fs::file_type::not_found;
  // To open a pipe would wait for its reader, who would then see it closed.
  if (!absent && type != fs::file_type::regular && type != fs::file_type::directory) return;
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC | (absent ? O_CREAT | O_EXCL : 0), 0600);
  if (file < 0) {
    throw InputError(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
  }
  close(file);
  if (absent) unlink(path.c_str());
}

void check_output(const char* name, const Text& path, const std::string& input) {
  if (!path) return;
  if (path->empty()) throw InputError(fmt::format("{}: names no file", name));
  if (!input.empty() && same_file(*path, input)) {
    throw InputError(fmt::format("{}: {} is the program that is read", name, *path));
  }
  if (same_file(*path, "/dev/stdout")) {
    throw InputError(fmt::format("{}: {} is where standard output goes", name, *path));
  }
}

void check_wave(const std::string& path, const std::string& input) {
  check_output("--wave", path, input);
  if (fs::path(path).extension() != ".fst" || fs::path(path).stem().empty()) {
    throw InputError(fmt::format("--wave: {} does not end in .fst", path));
  }
  check_writable(path);
}

}  // namespace

void check_outputs(const Common& common, const std::string& input) {
  check_output("--csv", common.csv, input);
  check_output("--report", common.report, input);
  check_output("--checkpoint", common.checkpoint, input);
  check_output("--plot", common.plot, input);
  const std::pair<const char*, const Text*> files[] = {{"--csv", &common.csv},
                                                       {"--report", &common.report},
                                                       {"--checkpoint", &common.checkpoint},
                                                       {"--plot", &common.plot},
                                                       {"--wave", &common.wave}};
  for (const auto& [name, file] : files) {
    for (const auto* before = files; before->second != file; ++before) {
      if (*file && *before->second && same_file(**file, **before->second)) {
        throw InputError(fmt::format("{}: {} is the file of {}", name, **file, before->first));
      }
    }
  }
  if (common.report) check_writable(*common.report);
  if (common.plot) {
    check_plot(*common.plot);
    check_writable(*common.plot);
  }
  if (common.wave) check_wave(*common.wave, input);
  common.window();
  if (common.checkpoint) check_writable(*common.checkpoint);
}

}  // namespace cosim::cli
