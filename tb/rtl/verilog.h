// Modules of Verilog as text, and edits of it. No grammar is read: comments and strings are
// blanked, and places stay.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cosim::rtl {

/// Bits of a net, as two groups of a Regex.
inline const std::string bits_of_net = "((\\s*\\[[^]]*\\])*)";

/// A piece of a text and where it begins.
struct Piece {
  std::string text;
  std::size_t at = 0;
};
/// The parts of a list between commas, without the blanks around them; the list begins at `at`.
std::vector<Piece> parts(std::string_view list, std::size_t at = 0);
std::string trimmed(std::string_view text);
/// The text without the parentheses around it.
inline std::string_view inside(std::string_view group) { return group.substr(1, group.size() - 2); }
/// Behind the parenthesis that closes the one at `at`; npos where there is none.
std::size_t group_end(std::string_view text, std::size_t at);
/// A text of Verilog without its comments.
std::string without_comments(std::string_view text);

struct Module {
  std::string name;
  std::size_t file = 0, at = 0;  ///< where its body begins
  std::string body;              ///< from behind its name on, blanked
};

/// What is before the first `;` of a module.
struct Head {
  std::string flat;          ///< the body without its tasks and functions
  std::size_t end = 0;       ///< behind the `;`
  std::size_t list_end = 0;  ///< the last parenthesis of the list of ports
  bool is_ansi = false;      ///< the list has the directions of the ports
  std::vector<Piece> items;  ///< of the list
};
/// InputError where it has no list of ports that can be read.
Head head_of(const Module& module);

struct Instance {
  std::string name;
  bool is_array = false, has_values = false;
  std::size_t begin = 0, end = 0;
  std::size_t last = 0;  ///< its last parenthesis
  std::vector<Piece> pins;
  Piece values;  ///< of its parameters, what is in the parentheses
};
/// The instances of the module `of`.
std::vector<Instance> instances(const std::string& of, std::string_view flat);
/// A pin `.NAME(NET)` or `.NAME`, of which NAME is the net too.
struct Joined {
  std::string pin, net;
};
/// Of such pins; others are left out.
std::vector<Joined> joined(const std::vector<Piece>& pins);
/// Whether a word is in the text.
bool has_word(std::string_view text, const std::string& word);

/// The modules of some files.
class Verilog {
 public:
  /// The files are named as from `folder`. InputError where one cannot be read.
  Verilog(const std::filesystem::path& folder, const std::vector<std::string>& files);

  std::map<std::string, Module> modules;  ///< the first one of a name

  std::string original(const Module& module, std::size_t at, std::size_t length) const {
    return texts_[module.file].substr(module.at + at, length);
  }
  bool has(const std::string& word) const;
  /// Has `by` in place of a piece of the module, on as many lines as before.
  void edit(const Module& module, std::size_t at, std::size_t length, std::string by);
  /// Writes the files that have edits into a folder, with `marks` behind a `line that says which
  /// they are. All files to read.
  std::vector<std::string> write(const std::filesystem::path& to, bool marks = true) const;

 private:
  struct Edit {
    std::size_t at, length;
    std::string by;
  };
  std::filesystem::path folder_;
  std::vector<std::string> files_, texts_, plain_;
  std::vector<std::vector<Edit>> edits_;
};

/// The files, and in place of those with `input d = 1'b0` copies in the folder `to` without these
/// defaults, but for inputs that an instance leaves open: Verilator 5.006 does not read them.
std::vector<std::string> without_port_defaults(const std::filesystem::path& folder,
                                               const std::vector<std::string>& files,
                                               const std::filesystem::path& to);

}  // namespace cosim::rtl
