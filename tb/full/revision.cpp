// git read-tree and checkout-index, with an index of their own. Not git archive, which changes what
// has the attributes export-subst and export-ignore.
#include "tb/full/equiv_sides.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "model/core/input_error.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

Ended git(const fs::path& at, const std::vector<std::string>& words,
          const std::vector<std::string>& variables = {}) {
  // As a hook of git has them set, for another repository or another index.
  std::vector<std::string> all{"env"};
  for (const char* one : {"GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX"}) {
    all.insert(all.end(), {"-u", one});
  }
  all.insert(all.end(), variables.begin(), variables.end());
  all.insert(all.end(), {"git", "-C", at.string()});
  all.insert(all.end(), words.begin(), words.end());
  Ended ended = cosim::run_program(all);
  if (ended.status == 127) throw InputError("--rev: needs git");
  while (ended.text.ends_with('\n')) ended.text.pop_back();
  return ended;
}

// Whether a path of git's leads to `folder`.
bool is_at(const std::string& path, const fs::path& folder) {
  std::error_code error;
  return fs::equivalent(path, folder, error) && !error;
}

// A path without "." and "..", which need not exist.
fs::path plain(const fs::path& path) {
  fs::path all = fs::absolute(path).lexically_normal();
  return all.has_filename() ? all : all.parent_path();
}

bool leads_out(const fs::path& relative) { return relative.empty() || *relative.begin() == ".."; }

// The root of the repository that a folder lies in, if it lies in one.
std::optional<fs::path> root_above(const fs::path& folder) {
  const Ended root = git(folder, {"rev-parse", "--show-toplevel"});
  if (root.text.find("dubious ownership") != std::string::npos) {
    throw InputError(
        fmt::format("--rev: git refuses the repository of {}, which another user owns; allow it by "
                    "git config --global --add safe.directory FOLDER",
                    folder.string()));
  }
  if (root.status != 0) return std::nullopt;
  return root.text;
}

// The repository that the files lie in; of several the one that has the others as submodules, or
// the one of the working directory.
fs::path repository_of(const std::vector<std::string>& files) {
  std::set<fs::path> roots;
  std::set<fs::path> folders;
  for (const std::string& file : files) folders.insert(plain(file).parent_path());
  for (const fs::path& folder : folders) {
    if (const auto root = root_above(folder)) roots.insert(*root);
  }
  if (roots.empty()) {
    throw InputError(fmt::format("--rev: {} is not in a git repository", files.front()));
  }
  const std::set<fs::path> all = roots;
  for (const fs::path& root : all) {
    fs::path above = root;
    do {
      above = git(above, {"rev-parse", "--show-superproject-working-tree"}).text;
    } while (!above.empty() && !all.contains(above));
    if (!above.empty()) roots.erase(root);
  }
  if (roots.size() == 1) return *roots.begin();
  const auto here = root_above(fs::current_path());
  if (here && roots.contains(*here)) return *here;
  throw InputError(
      fmt::format("--rev: the files are in the repositories {} and {}: call it in the "
                  "one whose revision is meant",
                  roots.begin()->string(), std::next(roots.begin())->string()));
}

}  // namespace

Revision::Revision(const std::string& rev, const std::vector<std::string>& files,
                   const fs::path& folder)
    : rev_(rev), root_(repository_of(files)), folder_(folder / "tree") {
  const bool named = !rev.empty() && rev.front() != '-';
  const Ended tree = named ? git(root_, {"rev-parse", "--verify", "--quiet", rev + "^{tree}"})
                           : Ended{1, false, 0, ""};
  if (tree.status != 0) throw InputError(fmt::format("--rev: {} is no revision", in_quotes(rev)));
  export_tree(root_, tree.text, "");
}

// Into the folder `inside` that of the revision.
void Revision::export_tree(const fs::path& repository, const std::string& tree,
                           const fs::path& inside) {
  const fs::path to = folder_ / inside;
  fs::create_directories(to);
  const std::string index = "GIT_INDEX_FILE=" + folder_.string() + ".index";
  const Ended read = git(repository, {"read-tree", tree}, {index});
  const Ended out =
      git(repository, {"--work-tree=" + to.string(), "checkout-index", "-a", "-f"}, {index});
  for (const Ended& ended : {read, out}) {
    if (ended.status == 0) continue;
    throw InputError(fmt::format("--rev: git cannot export the files of {}: {}", in_quotes(rev_),
                                 one_line(ended.text.substr(0, ended.text.find('\n')))));
  }
  const std::string entries = git(repository, {"ls-files", "-s", "-z"}, {index}).text;
  for (std::size_t at = 0; at < entries.size();) {
    // "MODE HASH STAGE<tab>PATH<0>"
    const std::size_t end = std::min(entries.find('\0', at), entries.size());
    const std::string entry = entries.substr(at, end - at);
    at = end + 1;
    const std::size_t tab = std::min(entry.find('\t'), entry.size() - 1);
    const fs::path path = inside / entry.substr(tab + 1);
    if (entry.starts_with("120000")) lead_on(folder_ / path, path);
    if (!entry.starts_with("160000")) continue;
    constexpr std::size_t mode = 7;
    const std::string commit = entry.substr(mode, entry.find(' ', mode) - mode);
    const fs::path module = root_ / path;
    if (!fs::is_directory(module) ||
        git(module, {"rev-parse", "--is-inside-work-tree"}).status != 0 ||
        !is_at(git(module, {"rev-parse", "--show-toplevel"}).text, module)) {
      lacking_[path.string()] = "is not here: git submodule update --init";
    } else if (git(module, {"cat-file", "-e", commit + "^{tree}"}).status != 0) {
      lacking_[path.string()] = "does not have " + commit + ": git fetch in it";
    } else {
      export_tree(module, commit, path);
    }
  }
}

// What lies in the repository is the revision's; what does not stays where it is.
void Revision::lead_on(const fs::path& link, const fs::path& inside) const {
  std::error_code error;
  const fs::path to = fs::read_symlink(link, error);
  if (error) return;
  const fs::path today = plain(to.is_absolute() ? to : (root_ / inside).parent_path() / to);
  const fs::path relative = today.lexically_relative(root_);
  const bool is_outside = leads_out(relative);
  if (to.is_relative() && !is_outside) return;
  fs::remove(link, error);
  fs::create_symlink(is_outside ? today : folder_ / relative, link, error);
}

// Its path in the repository: by the folders that it is named with, so that a link is looked up in
// the revision, not today.
std::optional<fs::path> Revision::inside(const fs::path& today) const {
  const fs::path all = plain(today);
  for (fs::path above = all;; above = above.parent_path()) {
    if (is_at(root_, above)) return all.lexically_relative(above);
    if (above == above.parent_path()) break;
  }
  std::error_code error;
  const fs::path real = fs::weakly_canonical(all, error).lexically_relative(fs::canonical(root_));
  if (error || leads_out(real)) return std::nullopt;
  return real;
}

std::optional<std::string> Revision::old(const fs::path& today, bool may_be_made) const {
  const auto path = inside(today);
  if (!path) return today.string();
  for (const auto& [module, why] : lacking_) {
    if (leads_out(path->lexically_relative(module))) continue;
    throw InputError(
        fmt::format("--rev: {} is in the submodule {}, which {}", today.string(), module, why));
  }
  const fs::path was = folder_ / *path;
  if (fs::exists(was)) return was.string();
  const auto is_tracked = [&] {
    return !git(root_, {"ls-files", "--", ":(top,literal)" + path->string()}).text.empty();
  };
  if (may_be_made && !is_tracked()) return today.string();
  return std::nullopt;
}

}  // namespace cosim::cli
