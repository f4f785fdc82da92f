#include "tb/util/quoted.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

void refuse(const std::string& text, const char* reader, std::string_view wrong) {
  const bool bad = std::ranges::any_of(text, [&](char c) {
    return std::iscntrl(static_cast<unsigned char>(c)) != 0 || wrong.find(c) != wrong.npos;
  });
  if (bad)
    throw InputError(
        fmt::format("{}: {} cannot read such a name; rename it", in_quotes(text), reader));
}

std::string escaped(const std::string& text, std::string_view special) {
  std::string safe;
  for (const char c : text) {
    if (special.find(c) != special.npos) safe += '\\';
    safe += c;
  }
  return safe;
}

// A word that needs no quotation, neither in CMake nor in a shell.
bool is_plain(const std::string& text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_./+-=").find(c) != std::string_view::npos;
  });
}

}  // namespace

std::string file_for_yosys(const std::filesystem::path& file) {
  refuse(file.string(), "yosys", "\"");
  // It takes a name for a pattern, as a shell does.
  return '"' + escaped(std::filesystem::absolute(file).string(), "*?[\\") + '"';
}

std::string word_for_yosys(const std::string& word) {
  refuse(word, "yosys", " \";");
  if (word.empty() || word.front() == '#') {
    throw InputError(fmt::format("{}: yosys cannot read such a name; rename it", in_quotes(word)));
  }
  return word;
}

std::string for_cmake(const std::string& text) {
  refuse(text, "CMake", ";");
  if (is_plain(text)) return text;
  return '"' + escaped(text, "\\\"$") + '"';
}

std::string for_shell(const std::string& text) {
  // a=b/program would be an assignment.
  if (is_plain(text) && text.find('=') == std::string::npos) return text;
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? "'\\''" : std::string(1, c);
  return safe + "'";
}

std::string for_gnuplot(const std::string& text) {
  refuse(text, "gnuplot", "");
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? "''" : std::string(1, c);
  return safe + "'";
}

}  // namespace cosim
