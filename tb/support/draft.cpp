#include "tb/support/draft.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/support/output_file.h"
#include "tb/support/replace_file.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

bool in_the_way(const std::error_code& error) {
  return error == std::errc::directory_not_empty || error == std::errc::file_exists ||
         error == std::errc::not_a_directory;
}

}  // namespace

Draft::Draft(const fs::path& root, const std::string& name)
    : target_(root / name),
      folder_(beside((root / ("." + name)).string())),
      half_(folder_.string()),
      old_(folder_.string() + ".old") {
  std::error_code error;
  fs::create_directories(root, error);
  if (!error && !fs::create_directory(folder_, error) && !error) {
    error = std::make_error_code(std::errc::file_exists);
  }
  if (error) fail(error);
}

Draft::~Draft() {
  std::error_code ignored;
  fs::remove_all(old_, ignored);
}

void Draft::write(const std::string& name, const std::string& text) const {
  write_file((folder_ / name).string(), text);
}

void Draft::finish() {
  std::error_code error;
  fs::rename(folder_, target_, error);
  for (int i = 0; i < 100 && in_the_way(error); ++i) {
    fs::remove_all(old_, error);
    fs::rename(target_, old_, error);
    fs::rename(folder_, target_, error);
  }
  if (error) fail(error);
}

void Draft::fail(const std::error_code& error) const {
  throw InputError(fmt::format("{}: cannot write: {}", target_.string(), error.message()));
}

}  // namespace cosim
