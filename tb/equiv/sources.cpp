#include "tb/equiv/sources.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"
#include "tb/util/pattern.h"
#include "tb/util/read_file.h"

namespace cosim::equiv {

namespace fs = std::filesystem;

namespace {

// What is known of a macro, or of a branch of `ifdef: a text may define it, here or elsewhere.
enum class Known { no, perhaps, yes };

class Branches {
 public:
  Branches(const Files& files, const std::vector<SourceText>& sources) {
    static const rtl::Regex change("`(define|undef)[ \t]+([A-Za-z_][A-Za-z0-9_$]*)");
    // Tools define names of their own; all of them are given SYNTHESIS.
    perhaps_ = {"YOSYS", "YOSYS_SLANG", "VERILATOR"};
    for (const std::string& one : files.defines) perhaps_.insert(one.substr(0, one.find('=')));
    for (const SourceText& source : sources) {
      for (const rtl::Match& one : change.all(source.text)) perhaps_.insert(one[2]);
    }
  }

  // The text with blanks in place of the branches that no tool takes.
  std::string taken(std::string text) const {
    static const rtl::Regex directive(
        "`(ifdef|ifndef|elsif|else|endif)\\b[ \t]*([A-Za-z_][A-Za-z0-9_$]*)?");
    struct Level {
      Known now = Known::yes, before = Known::no;  // the branch, and any of those before it
    };
    std::vector<Level> levels;
    std::size_t from = 0;
    const std::string code = rtl::code_of(text);
    for (const rtl::Match& found : directive.all(code)) {
      const bool is_left =
          std::ranges::any_of(levels, [](const Level& level) { return level.now == Known::no; });
      for (std::size_t i = from; is_left && i < found.begin(); ++i) {
        if (text[i] != '\n') text[i] = ' ';
      }
      from = found.end();
      const std::string word = found[1];
      if (word == "ifdef") levels.push_back({known(found[2])});
      if (word == "ifndef") levels.push_back({turned(known(found[2]))});
      if (levels.empty() || word.starts_with("if")) continue;
      Level& level = levels.back();
      level.before = std::max(level.before, level.now);
      level.now = turned(level.before);
      if (word == "elsif") level.now = std::min(level.now, known(found[2]));
      if (word == "endif") levels.pop_back();
    }
    return text;
  }

 private:
  static Known turned(Known known) {
    return known == Known::yes ? Known::no : known == Known::no ? Known::yes : Known::perhaps;
  }
  Known known(const std::string& macro) const {
    if (perhaps_.contains(macro) || macro.starts_with("__")) return Known::perhaps;
    return macro == "SYNTHESIS" ? Known::yes : Known::no;
  }

  std::set<std::string> perhaps_;
};

}  // namespace

std::vector<SourceText> sources_of(const Files& files) {
  static const Pattern include(R"re(`include\s*"([^"]+)")re"), other(R"re(`include\s*[^"\s])re");
  std::vector<fs::path> all = files.files, folders = files.include_dirs;
  folders.push_back(files.folder);
  for (const fs::path& file : files.files) folders.push_back(file.parent_path());
  std::vector<SourceText> sources;
  bool are_all = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    sources.push_back({all[i], i >= files.files.size(), read_file(all[i].string())});
    are_all = are_all && !other.in(sources.back().text);
    for (const Pattern::Parts& part : include.all(sources.back().text)) {
      bool is_found = false;
      for (const fs::path& folder : folders) {
        const fs::path file = folder / part[1];
        if (!fs::is_regular_file(file)) continue;
        is_found = true;
        if (std::ranges::find(all, file) == all.end()) all.push_back(file);
      }
      are_all = are_all && is_found;
    }
  }
  const auto has_branches = [](const SourceText& one) {
    return one.text.find("`if") != std::string::npos;
  };
  // What is not found may define any macro.
  if (!are_all || std::ranges::none_of(sources, has_branches)) return sources;
  const Branches branches(files, sources);
  for (SourceText& source : sources) {
    if (has_branches(source)) source.text = branches.taken(std::move(source.text));
  }
  return sources;
}

std::string place_in(const SourceText& source, std::size_t at) {
  const auto begin = source.text.begin();
  return fmt::format("{}:{}", source.file.string(),
                     1 + std::count(begin, begin + std::ptrdiff_t(at), '\n'));
}

std::string place_of(const std::vector<SourceText>& sources, const std::string& expression) {
  const rtl::Regex regex(expression);
  for (const SourceText& source : sources) {
    const std::string plain = rtl::blanked(source.text);
    const rtl::Match found = regex.find(plain);
    if (!found) continue;
    return place_in(source, found.begin());
  }
  return "";
}

bool has_types_of_two_values(const std::vector<SourceText>& sources) {
  static const std::string two = "(bit|byte|shortint|int|longint)";
  for (const std::string& expression :
       {"\\benum\\s*(\\{|" + two + "\\b)", "\\b(struct|union)\\b[^{;]*\\{[^}]*\\b" + two + "\\b",
        "\\btypedef\\s+" + two + "\\b"}) {
    if (!place_of(sources, expression).empty()) return true;
  }
  return false;
}

std::string place_of_two_valued_port(std::vector<SourceText> sources) {
  static const rtl::Regex own("\\b(function|task)\\b");
  for (SourceText& one : sources) {
    one.text = rtl::blanked(one.text);
    for (rtl::Match found = own.find(one.text); found;) {
      const std::size_t from = found.begin();
      const std::size_t end = std::min(one.text.find("end" + found[1], from), one.text.size());
      std::replace_if(
          one.text.begin() + std::ptrdiff_t(from), one.text.begin() + std::ptrdiff_t(end),
          [](char c) { return c != '\n'; }, ' ');
      found = own.find(one.text, end);
    }
  }
  return place_of(sources,
                  "\\b(input|output|inout)\\s+(var\\s+)?(bit|byte|shortint|int|longint)\\b");
}

std::string unused_name(std::string begins, const std::vector<SourceText>& sources) {
  const auto has_it = [&](const SourceText& one) {
    return one.text.find(begins) != std::string::npos;
  };
  while (std::ranges::any_of(sources, has_it)) begins += '_';
  return begins;
}

}  // namespace cosim::equiv
