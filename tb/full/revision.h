// The files of a git repository as they were in a revision.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cosim::cli {

/// What a checkout of the revision would have, in a folder of its own: the repository stays as it
/// is. A submodule has the commit that the revision names, where its own repository has that. A
/// link that leads out of the repository leads where it does today.
class Revision {
 public:
  /// Of the repository that `file` lies in. InputError "--rev: ...", one line.
  Revision(const std::string& rev, const std::filesystem::path& file,
           const std::filesystem::path& folder);

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
