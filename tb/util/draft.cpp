#include "tb/util/draft.h"

#include <fmt/core.h>

#include <set>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_of_files = ".cosim";

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    std::error_code none;
    const bool is_folder = at->symlink_status(none).type() == fs::file_type::directory;
    if (is_folder && !fs::is_empty(at->path(), none)) continue;
    names.insert(at->path().lexically_relative(folder).string());
  }
  return names;
}

bool in_the_way(const std::error_code& error) {
  return error == std::errc::directory_not_empty || error == std::errc::file_exists ||
         error == std::errc::not_a_directory;
}

}  // namespace

// What a person put there stays, and so does a file or a link in the folder's place.
void require_own_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(folder, error).type();
  if (type == fs::file_type::not_found || type == fs::file_type::none) return;
  if (type != fs::file_type::directory) {
    throw InputError(folder.string() +
                     ": is not a folder and is not replaced; move it or name another");
  }
  std::set<std::string> own{list_of_files};
  if (const fs::path list = folder / list_of_files; fs::is_regular_file(list, error)) {
    std::istringstream lines(read_file(list.string()));
    for (std::string line; std::getline(lines, line);) own.insert(line);
  }
  for (const std::string& name : files_in(folder)) {
    if (own.contains(name)) continue;
    throw InputError(fmt::format(
        "{}: has {}, which is not from an earlier run: nothing is replaced; move that file",
        folder.string(), one_line(name)));
  }
}

Draft::Draft(const fs::path& root, const std::string& name)
    : target_(root / name),
      folder_(beside((root / ("." + name)).string())),
      old_(folder_.string() + ".old") {
  require_own_folder(target_);
  std::error_code error;
  fs::create_directories(root, error);
  if (!error && !fs::create_directory(folder_, error) && !error) {
    error = std::make_error_code(std::errc::file_exists);
  }
  if (error) fail(error);
}

Draft::~Draft() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  fs::remove_all(old_, ignored);
}

void Draft::write(const std::string& name, const std::string& text) const {
  write_file((folder_ / name).string(), text);
}

void Draft::finish_replacing() {
  std::string list;
  for (const std::string& name : files_in(folder_)) list += name + '\n';
  write(list_of_files, list);
  std::error_code error;
  fs::rename(folder_, target_, error);
  for (int i = 0; i < 100 && in_the_way(error); ++i) {
    require_own_folder(target_);
    fs::rename(target_, old_, error);
    fs::rename(folder_, target_, error);
    std::error_code ignored;
    if (error && !in_the_way(error)) fs::rename(old_, target_, ignored);
    fs::remove_all(old_, ignored);
  }
  if (error) fail(error);
}

void Draft::finish() {
  std::error_code error;
  fs::rename(folder_, target_, error);
  if (error) fail(error);
}

void Draft::fail(const std::error_code& error) const {
  throw InputError(fmt::format("{}: cannot write: {}", target_.string(), error.message()));
}

}  // namespace cosim
