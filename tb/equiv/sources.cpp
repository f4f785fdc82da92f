#include "tb/equiv/sources.h"

#include <fmt/core.h>

#include <algorithm>

#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"
#include "tb/util/pattern.h"
#include "tb/util/read_file.h"

namespace cosim::equiv {

namespace fs = std::filesystem;

std::vector<SourceText> sources_of(const Files& files) {
  static const Pattern include(R"re(`include\s*"([^"]+)")re");
  std::vector<fs::path> all = files.files, folders = files.include_dirs;
  folders.push_back(files.folder);
  for (const fs::path& file : files.files) folders.push_back(file.parent_path());
  std::vector<SourceText> sources;
  for (std::size_t i = 0; i < all.size(); ++i) {
    sources.push_back({all[i], i >= files.files.size(), read_file(all[i].string())});
    for (const Pattern::Parts& part : include.all(sources.back().text)) {
      for (const fs::path& folder : folders) {
        const fs::path file = folder / part[1];
        if (fs::is_regular_file(file) && std::ranges::find(all, file) == all.end()) {
          all.push_back(file);
        }
      }
    }
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
