// The files of one side, as a front end is given them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/equiv/side.h"
#include "tb/equiv/yosys_messages.h"
#include "tb/util/process.h"

namespace cosim::equiv {

/// What follows what makes cells of processes, whichever front end it was: one module. Nothing is
/// made simpler by what an x may be taken for.
inline constexpr const char* to_cells =
    "\nsetattr -mod -unset keep_hierarchy *\nsetattr -unset keep_hierarchy */c:*\n"
    "flatten\ncheck\nopt_clean\nmemory_collect\nopt_clean\n";

/// `proc -noopt` without proc_rmdead, which takes an item of `case` with an x for one that covers
/// those behind it, and without proc_rom. proc_rmdead also sees where items cover all values, so
/// that no latch is made; it is left out only where there is such an item.
inline constexpr const char* without_rmdead =
    "proc_clean; proc_prune; proc_init; proc_arst; proc_mux; proc_dlatch; proc_dff; proc_memwr; "
    "proc_clean";
inline constexpr const char* with_rmdead = "proc -noopt";

/// Files and folders have names of ours in `scratch`: nothing that a person types is read as a
/// command. A file stands in its own folder, where $readmemh and `include look for others first.
class Reading {
 public:
  /// InputError for a definition or a parameter that is none. `files` must outlive it.
  Reading(const Files& files, const std::filesystem::path& scratch);

  /// What is read in place of file i: the file itself where that is its text.
  std::string file(std::size_t i, const std::string& text);
  static std::string extension(const std::filesystem::path& file) {
    return file.extension() == ".sv" ? ".sv" : ".v";
  }
  const std::vector<std::filesystem::path>& folders() const { return links_; }
  const std::vector<std::pair<std::string, std::string>>& parameters() const { return parameters_; }

  /// Files and folders by the names that they have in the script, and by their own.
  FileNames names() const;
  /// A text with the files by their own names.
  std::string by_own_names(std::string text) const;

 private:
  std::filesystem::path folder_of(const std::filesystem::path& folder);

  const Files& files_;
  std::filesystem::path scratch_;
  std::map<std::filesystem::path, std::size_t> at_;
  std::vector<std::filesystem::path> links_;  // of the files, of --include, the working directory
  std::vector<std::pair<std::string, std::string>> parameters_;
};

/// What a front end that said this has read, but not as Verilog says; "" where there is no such
/// thing.
std::string misread(const std::string& said, const Reading& reading);

/// Runs a front end in `folder`. OutOfTime.
Ended run_reader(std::vector<std::string> words, const std::filesystem::path& scratch,
                 const std::filesystem::path& folder, const Budget& budget);

}  // namespace cosim::equiv
