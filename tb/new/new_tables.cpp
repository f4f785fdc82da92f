// The tables of a model, from the nets of RTL that was read.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "tb/new/new.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

// The widest elements of equal width, at most 64 bits, that make up a word of a memory.
int part_of(const FoundNet& memory) {
  constexpr int widest = 64;
  int part = std::min(memory.width.number, widest);
  while (memory.width.number % part != 0) --part;
  return part;
}

std::string text_of(const NewRow& row) {
  const FoundNet& net = row.net;
  const int width = net.width.number, words = net.words.number;
  std::string format = width == 1 && net.width.text.empty() ? "flag" : "bits";
  std::string shown = text_of(net.width);
  if (words == 0 && width > 64) {
    format += fmt::format(".words<{}>()", (width + 63) / 64);
  } else if (words != 0) {
    const int part = part_of(net);
    if (part != width) {
      shown = std::to_string(part);
      format += fmt::format(".array<{}>()", words * (width / part));
    } else {
      const bool fixed = net.words.text.empty();
      format += fmt::format(".array<{}>({})", words, fixed ? "" : text_of(net.words));
    }
  }
  if (net.edge != Edge::none) format = net.edge == Edge::rising ? "rises" : "falls";
  if (row.elsewhere) format += fmt::format(".at(\"{}\")", row.at());
  if (!net.is_reset) format += ".unreset()";
  return fmt::format("FIELD({}, {}, {}, \"\", \"\")", row.field, shown, format);
}

// A word of C++, such as `delete`; what records (model/core/record.h) and their templates have
// already; and macros of the C library and of GNU compilers.
bool is_taken(const std::string& name) {
  static constexpr const char* cpp =
      "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
      "char32_t char8_t class co_await co_return co_yield compl concept const const_cast "
      "consteval constexpr constinit continue decltype default delete do double dynamic_cast "
      "else enum explicit export extern false float for friend goto if inline int long mutable "
      "namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
      "register reinterpret_cast requires return short signed sizeof static static_assert "
      "static_cast struct switch template this thread_local throw true try typedef typeid "
      "typename union unsigned using virtual void volatile wchar_t while xor xor_eq";
  static constexpr const char* others =
      "V p Inputs Outputs State Table Index size Self members fields trim select index_end "
      "Record Params has_arrays FIELD Word std cosim each_member Visit EOF NULL BUFSIZ errno "
      "assert stdin stdout stderr linux unix i386 select_record Condition Field RAND_MAX "
      "CHAR_BIT offsetof INFINITY NAN SIZE_MAX";
  static const std::set<std::string> all = [] {
    const auto words = words_in(fmt::format("{} {}", cpp, others));
    return std::set<std::string>(words.begin(), words.end());
  }();
  return name.starts_with("index_") || name.starts_with("final_index_") || all.contains(name);
}

}  // namespace

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string field_of(const std::string& path) {
  std::string name = path;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  if (std::isdigit(static_cast<unsigned char>(name.front())) != 0) name = '_' + name;
  return is_taken(name) ? name + '_' : name;
}

std::string text_of(const FoundSize& size) {
  return size.text.empty() ? std::to_string(size.number) : size.text;
}

std::string table_of(const std::string& name, const std::vector<NewRow>& rows) {
  std::string text = fmt::format("#define {}(FIELD)", name);
  for (const NewRow& row : rows) text += " \\\n  " + text_of(row);
  return text + '\n';
}

std::string params_of(const Found& found) {
  std::string members;
  for (const FoundParameter& p : found.parameters) {
    members += p.is_text ? fmt::format("  const char* {} = \"{}\";\n", field_of(p.name), p.value)
                         : fmt::format("  int {} = {};\n", field_of(p.name), p.value);
  }
  return "struct Params {\n" + members + "};\n";
}

std::string parameters_of(const Found& found) {
  std::string pairs;
  for (const FoundParameter& p : found.parameters) {
    pairs += fmt::format("{}{{\"{}\", p.{}}}", pairs.empty() ? "" : ", ", p.name, field_of(p.name));
  }
  if (pairs.empty()) return "";
  return fmt::format(
      "  static constexpr std::array<Parameter, {}> parameters(const Params& p) {{\n"
      "    return {{{{{}}}}};\n"
      "  }}\n",
      found.parameters.size(), pairs);
}

}  // namespace cosim::cli
