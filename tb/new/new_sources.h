// The files that a design needs, of those that a person names or that lie in a folder.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace cosim::cli {

/// What is typed behind `cosim new NAME`.
struct GivenRtl {
  std::string name;                         ///< of the design
  std::vector<std::string> files = {};      ///< files and folders
  std::vector<std::string> libraries = {};  ///< files, and folders, of modules to take where needed
  std::vector<std::string> includes = {};   ///< folders of headers
  std::string top = {};                     ///< "": to be found
  std::set<std::string> uses = {};          ///< words that may be packages, which are needed too
};

/// A file of the project.
struct SourceFile {
  std::string name;            ///< in the project
  std::filesystem::path from;  ///< as it was named or found
  std::string text = {};
};

struct Sources {
  std::string top;
  bool top_is_guessed = false;  ///< by the name of the first file
  /// Packages first, then the top and what it needs; files that were named are all there.
  std::vector<SourceFile> files;
  std::vector<std::string> left_out;  ///< but for these, which are testbenches
  std::vector<SourceFile> headers;    ///< by the names that `include gives them
};

/// InputError, one line, where the top cannot be told and for a file that cannot be read.
Sources sources_of(const GivenRtl& given);

/// InputError for a module, an interface or a package that is in two of the files that are named.
void require_homes(const Sources& sources, const std::vector<std::string>& named);

/// The files as they are named; but if one of them uses a package of a file behind it, the packages
/// before all others.
std::vector<std::string> in_order(std::vector<std::string> files);

}  // namespace cosim::cli
