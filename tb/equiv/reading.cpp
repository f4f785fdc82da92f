#include "tb/equiv/reading.h"

#include <fmt/core.h>

#include "model/core/input_error.h"
#include "tb/util/output_file.h"
#include "tb/util/pattern.h"
#include "tb/util/quoted.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::equiv {

namespace fs = std::filesystem;

Reading::Reading(const Files& files, const fs::path& scratch) : files_(files), scratch_(scratch) {
  for (const fs::path& file : files.files) folder_of(fs::absolute(file).parent_path());
  for (const fs::path& folder : files.include_dirs) folder_of(fs::absolute(folder));
  folder_of(fs::absolute(files.folder));
  static const Pattern good(R"([A-Za-z_]\w*(=[\w']+)?)");
  for (const std::string& define : files.defines) {
    if (good.whole(define).empty()) {
      throw InputError(fmt::format("--define: {} is not NAME or NAME=VALUE", in_quotes(define)));
    }
  }
  static const Pattern parameter(R"(([A-Za-z_][\w$]*)=(-?[\w']+|-?\d+\.\d+|"[^"\\]*"))");
  for (const std::string& one : files.parameters) {
    const Pattern::Parts part = parameter.whole(one);
    if (part.empty()) {
      throw InputError(fmt::format("--param: {} is not NAME=VALUE", in_quotes(one)));
    }
    parameters_.emplace_back(part[1], part[2]);
  }
}

std::string Reading::file(std::size_t i, const std::string& text) {
  const fs::path& file = files_.files[i];
  const fs::path folder = folder_of(fs::absolute(file).parent_path());
  static const Pattern plain(R"([\w.+-]+)");
  const std::string name = file.filename().string();
  const bool is_same = text == read_file(file.string());
  if (is_same && !plain.whole(name).empty()) return (folder / name).string();
  const fs::path own = scratch_ / fmt::format("file{}{}", i, extension(file));
  fs::remove(own);
  if (is_same) {
    fs::create_symlink(fs::absolute(file), own);
  } else {
    write_file(own.string(), text);
  }
  return own.string();
}
FileNames Reading::names() const {
  FileNames all;
  for (std::size_t i = 0; i < files_.files.size(); ++i) {
    const fs::path& file = files_.files[i];
    all.emplace_back((scratch_ / fmt::format("file{}{}", i, extension(file))).string(),
                     file.string());
    all.emplace_back((links_[at_.at(fs::absolute(file).parent_path())] / file.filename()).string(),
                     file.string());
  }
  for (const auto& [folder, at] : at_) all.emplace_back(links_[at].string(), folder.string());
  return all;
}
std::string Reading::by_own_names(std::string text) const {
  for (const auto& [old, by] : names()) {
    for (std::size_t p = 0; (p = text.find(old, p)) != std::string::npos; p += by.size()) {
      text.replace(p, old.size(), by);
    }
  }
  return text;
}

fs::path Reading::folder_of(const fs::path& folder) {
  const auto [at, is_new] = at_.try_emplace(folder, links_.size());
  if (is_new) {
    const fs::path link = scratch_ / fmt::format("folder{}", links_.size());
    fs::create_directory_symlink(folder, link);
    word_for_yosys(link.string());
    links_.push_back(link);
  }
  return links_[at->second];
}

std::string misread(const std::string& said, const Reading& reading) {
  static const Pattern undeclared(
      R"(([^\n]*): Warning: Identifier `\\?([^\n']*[.$][^\n']*)' is implicitly declared\.)");
  for (const Pattern::Parts& part : undeclared.all(said)) {
    const bool is_system = part[2].front() == '$';
    return fmt::format(
        "{}: {}: {}", reading.by_own_names(part[1]), part[2],
        is_system ? "a system function that is not known" : "a name in another module");
  }
  static const Pattern drivers(R"(multiple conflicting drivers for [^\s.]+\.(\\?)([^\n]*):)");
  for (const Pattern::Parts& part : drivers.all(said)) {
    return part[1].empty() ? "a net without a name has several drivers"
                           : fmt::format("net {} has several drivers", part[2]);
  }
  return "";
}

Ended run_reader(std::vector<std::string> words, const fs::path& scratch, const fs::path& folder,
                 const Budget& budget) {
  words.insert(words.begin(), {"env", "-u", "XDG_STATE_HOME", "-C", folder.string(),
                               "HOME=" + scratch.string(), "TMPDIR=" + scratch.string()});
  Ended ended = run_until(words, budget.ends());
  if (ended.timed_out) throw OutOfTime();
  return ended;
}

}  // namespace cosim::equiv
