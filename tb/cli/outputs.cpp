#include "tb/cli/outputs.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/cli/wave.h"
#include "tb/show/plot.h"
#include "tb/show/view.h"
#include "tb/util/words.h"

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

// The ending decides what is written. A name that is nothing but an ending is a hidden file.
void check_ending(const char* option, const std::string& path,
                  const std::vector<std::string>& endings) {
  const std::string name = path.substr(path.find_last_of('/') + 1);
  for (const std::string& ending : endings) {
    if (name == ending) {
      throw InputError(
          fmt::format("{}: {} has no name before its {}", option, in_quotes(path), ending));
    }
    if (name.ends_with(ending)) return;
  }
  throw InputError(path.empty() ? fmt::format("{}: names no file", option)
                                : fmt::format("{}: {} does not end in {}", option, path,
                                              fmt::join(endings, " or ")));
}

[[noreturn]] void cannot_write(const std::string& path, const char* why) {
  throw InputError(fmt::format("{}: cannot write: {}", path, why));
}

// Neither creates nor changes a file.
void check_writable(const std::string& path) {
  std::error_code error;
  const fs::file_type type = fs::status(path, error).type();
  if (type == fs::file_type::not_found) {
    if (fs::is_symlink(path, error)) cannot_write(path, "a link to nothing");
    const fs::path folder = fs::path(path).parent_path();
    const char* const in = folder.empty() ? "." : folder.c_str();
    if (access(in, W_OK) != 0) cannot_write(path, std::strerror(errno));
    return;
  }
  if (type == fs::file_type::none) cannot_write(path, error.message().c_str());
  // Opening a pipe would wait for its reader, which would then see it closed.
  if (type != fs::file_type::regular && type != fs::file_type::directory) return;
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) cannot_write(path, std::strerror(errno));
  close(file);
}

// Whether a wave can replace what is there: a file, or a link.
bool gives_way(const std::string& path) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  return type == fs::file_type::not_found || type == fs::file_type::regular ||
         type == fs::file_type::symlink;
}

constexpr std::string_view wave_option = "--wave";

// A file that an option writes.
struct Output {
  std::string_view option;
  std::string path;
};

std::vector<Output> outputs_of(const Common& common, const WavesOf& waves) {
  std::vector<Output> all;
  const auto add = [&](const char* option, const Text& path) {
    if (path && path->empty()) throw InputError(fmt::format("{}: names no file", option));
    if (path) all.push_back({option, *path});
  };
  add("--csv", common.csv);
  add("--report", common.report);
  add("--junit", common.junit);
  add("--checkpoint", common.checkpoint);
  add("--plot", common.plot);
  add("--html", common.html);
  if (!common.wave) return all;
  for (const AnyBench* bench : waves) {
    const std::string file = wave_file(*common.wave, waves.size() > 1 ? bench->design() : "");
    add("--wave", file);
    for (const std::string& beside : view_files(file, bench->probes())) add("--wave", beside);
  }
  return all;
}

void check_apart(const std::vector<Output>& all, const std::vector<std::string>& inputs) {
  for (const Output& one : all) {
    for (const std::string& input : inputs) {
      if (input.empty() || !same_file(one.path, input)) continue;
      throw InputError(fmt::format("{}: {} is the file that is read", one.option, one.path));
    }
    if (same_file(one.path, "/dev/stdout")) {
      throw InputError(fmt::format("{}: {} is where standard output goes", one.option, one.path));
    }
    for (const Output& before : all) {
      if (&before == &one) break;
      if (same_file(one.path, before.path)) {
        throw InputError(
            fmt::format("{}: {} is the file of {}", one.option, one.path, before.option));
      }
    }
  }
}

}  // namespace

void check_outputs(const Common& common, const std::vector<std::string>& inputs,
                   const WavesOf& waves) {
  if (common.wave) check_ending("--wave", *common.wave, {".fst"});
  if (common.html) check_ending("--html", *common.html, {".html"});
  if (common.failures && common.failures->empty()) throw InputError("--failures: names no folder");
  const std::vector<Output> all = outputs_of(common, waves);
  check_apart(all, inputs);
  if (common.plot) {
    check_ending("--plot", *common.plot, {".svg", ".png"});
    check_plot();
  }
  common.window();
  for (const Output& one : all) {
    check_writable(one.path);
    if (one.option == wave_option && !gives_way(one.path)) {
      throw InputError(fmt::format("{}: {} cannot be replaced by a file", wave_option, one.path));
    }
  }
}

}  // namespace cosim::cli
