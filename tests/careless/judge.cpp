#include "tests/careless/judge.h"

#include <algorithm>
#include <csignal>
#include <filesystem>

namespace cosim::careless {
namespace {

namespace fs = std::filesystem;

constexpr long most_memory = 1'500'000'000;

bool has(const Case& one, const char* argument) {
  return std::find(one.arguments.begin(), one.arguments.end(), argument) != one.arguments.end();
}

// The files that an argument may stand for, as paths below the scratch folder: its own, those that
// are made from its name, and all in a folder of that name.
class Asked {
 public:
  Asked(const Case& one, const Scratch& scratch) : killed_(one.signal == SIGKILL) {
    if (has(one, "regress"))
      folders_.emplace_back("work/regressions/");  // where no folder is named
    for (const auto& named : one.named) {
      if (named.value.empty()) continue;
      // A name may be too long to be looked for.
      std::error_code ignored;
      fs::path place = fs::weakly_canonical(scratch.work() / named.value, ignored);
      if (place.empty()) place = (scratch.work() / named.value).lexically_normal();
      const fs::path path = place.lexically_relative(scratch.folder());
      paths_.push_back(path.string());
      // Only a wave has files beside it.
      if (path.extension() == ".fst")
        stems_.push_back(path.string().substr(0, path.string().size() - 4));
      if (named.option == "--failures" || named.option == "--keep")
        folders_.push_back(path.string() + '/');
    }
  }

  bool names(std::string path, bool folder) const {
    // The one signal that nobody can take: FILE.NUMBER.cosim-new is left, and a temporary folder.
    if (killed_ && path.ends_with(".cosim-new")) path.resize(path.size() - 27);
    if (killed_ && (path.ends_with(".hier") || path.starts_with("tmp/cosim."))) return true;
    if (std::find(paths_.begin(), paths_.end(), path) != paths_.end()) return true;
    for (const std::string& stem : stems_) {
      // A wave of one design among several has its name, the words of a probe have that of the
      // probe.
      if (!path.starts_with(stem + ".") || path.find('/', stem.size()) != std::string::npos)
        continue;
      for (const char* end : {".fst", ".gtkw", ".txt"}) {
        if (path.ends_with(end)) return true;
      }
    }
    return std::any_of(folders_.begin(), folders_.end(), [&](const std::string& one) {
      return path.starts_with(one) || (folder && one.starts_with(path + '/'));
    });
  }

 private:
  bool killed_;
  std::vector<std::string> paths_, stems_, folders_;
};

void check_status(const Case& one, const Came& came, std::vector<std::string>& found) {
  const bool by_signal = came.signalled && came.status == 128 + one.signal;
  const bool by_pipe =
      (one.out == Stream::gone || one.err == Stream::gone) && came.status == 128 + SIGPIPE;
  if (came.hung) found.push_back("does not end on signal " + std::to_string(one.signal));
  if (came.hung || by_signal || by_pipe) return;
  // What may say 1 of designs that are as they should be: a time that is over, a bit not reached, a
  // plan of what fails.
  const bool verdict =
      has(one, "prove") || has(one, "cover") || has(one, "mutate") || has(one, "regress");
  if (came.status != 0 && came.status != 2 && !(came.status == 1 && verdict)) {
    found.push_back("status " + std::to_string(came.status));
  }
  if (one.err != Stream::file || one.largest_file != 0) return;
  if (came.status == 2 && came.err.empty()) found.push_back("status 2 and not a word");
  if (came.status == 0 && !came.err.empty()) found.push_back("status 0 and an error: " + came.err);
}

void check_error(const Case& one, const Came& came, std::vector<std::string>& found) {
  const auto ends = std::count(came.err.begin(), came.err.end(), '\n');
  const bool cut = one.largest_file != 0 || came.signalled;
  if (ends > 1 || (ends == 0 && !came.err.empty() && !cut)) {
    found.push_back("standard error is not one line: " + came.err.substr(0, 1000));
  }
  if (!came.err.empty() && !came.err.starts_with("cosim: ") && !cut)
    found.push_back("standard error: " + came.err);
  if (came.err.find("internal error") != std::string::npos) found.push_back(came.err);
  for (const std::string& text : {came.out, came.err}) {
    for (const char* figure : {" inf ", " nan ", " -nan ", " inf,", " nan,"}) {
      if (text.find(figure) != std::string::npos)
        found.push_back("a figure is" + std::string(figure));
    }
  }
}

}  // namespace

std::vector<std::string> faults(const Case& one, const Came& came, const Scratch& scratch,
                                const Held& before, const Held& after) {
  std::vector<std::string> found;
  check_status(one, came, found);
  check_error(one, came, found);
  if (came.left != 0 && one.signal != SIGKILL) found.push_back("leaves a process");
  if (came.peak > most_memory)
    found.push_back("takes " + std::to_string(came.peak) + " bytes of memory");

  const Asked asked(one, scratch);
  for (const auto& [path, held] : before) {
    if (after.count(path) == 0 && !asked.names(path, held == "folder"))
      found.push_back("is gone: " + path);
  }
  for (const auto& [path, held] : after) {
    const auto old = before.find(path);
    if (old != before.end() && old->second == held) continue;
    if (!asked.names(path, held == "folder")) {
      found.push_back((old == before.end() ? "is new: " : "is changed: ") + path);
      continue;
    }
    // Of one that was killed.
    if (path.find(".cosim-new") != std::string::npos || path.starts_with("tmp/")) continue;
    if (const std::string why = unsound((scratch.folder() / path).string()); !why.empty()) {
      found.push_back(path + ": " + why);
    }
  }
  return found;
}

}  // namespace cosim::careless
