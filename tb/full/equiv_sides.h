// The two RTLs of `cosim equiv`: which files each of them is read from.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tb/cli/common.h"
#include "tb/equiv/side.h"

namespace cosim::cli {

struct EquivOptions {
  std::vector<std::string> gold, gate, files, cells, blackboxes, parameters, gold_parameters,
      gate_parameters, include_dirs, defines, resets, tied, ignored, renamed, same, assumed, lists,
      own_lists;
  Text rev, top, gold_top, gate_top, seconds, jobs, reset_clocks, latency, keep;
  bool netlists = false;
  Common common;
};

/// What one side is read from, and where its working directory is.
struct SideFiles {
  std::vector<std::string> files, cells, include_dirs, defines;
  std::vector<std::string> libraries;  ///< files, and folders, of modules to take where needed
  std::filesystem::path folder = ".";
};

struct BothFiles {
  SideFiles gold, gate;
};

/// Each side's own, those of lists of files (tb/rtl/file_list.h) too: with --rev those of the old
/// one are what git has, in `scratch`. InputError where the options name none.
BothFiles files_of(const EquivOptions& options, const std::filesystem::path& scratch);
/// --top, --gate-top, or the one module of the new files that no other has an instance of.
/// InputError where there are more.
std::string top_of(const EquivOptions& options, const SideFiles& gate);
/// All files that are named today, the lists among them. A list that cannot be read names none.
std::vector<std::string> files_named(const EquivOptions& options);

struct BothSides {
  std::optional<equiv::Side> gold, gate;
};

/// Reads both at once, on `jobs` threads at the most, from `top` unless a side's own is named.
/// `folder`: one for temporary files. InputError, and OutOfTime.
BothSides read_sides(const EquivOptions& options, const BothFiles& files, const std::string& top,
                     const std::filesystem::path& folder, const equiv::Budget& budget,
                     unsigned jobs);

// The files of a git repository as they were in a revision.

/// What a checkout of the revision would have, in a folder of its own: the repository stays as it
/// is. A submodule has the commit that the revision names, where its own repository has that. A
/// link that leads out of the repository leads where it does today.
class Revision {
 public:
  /// Of the repository that the files lie in; of several the one that has the others as
  /// submodules, or the one of the working directory. InputError "--rev: ...", one line.
  Revision(const std::string& rev, const std::vector<std::string>& files,
           const std::filesystem::path& folder);

  /// Whether it lies in the repository.
  bool has(const std::filesystem::path& today) const { return inside(today).has_value(); }

  /// What a file or a folder of today is in the revision: none where it is not there. What lies
  /// outside of the repository stays where it is, and so does with `may_be_made` what git knows
  /// nothing of: a build has made it. InputError for one of a submodule that could not be had.
  std::optional<std::string> old(const std::filesystem::path& today,
                                 bool may_be_made = false) const;

 private:
  void export_tree(const std::filesystem::path& repository, const std::string& tree,
                   const std::filesystem::path& inside);
  void lead_on(const std::filesystem::path& link, const std::filesystem::path& inside) const;
  std::optional<std::filesystem::path> inside(const std::filesystem::path& today) const;

  std::string rev_;
  std::filesystem::path root_, folder_;
  std::map<std::string, std::string> lacking_;  ///< submodules by their paths; why
};

}  // namespace cosim::cli
