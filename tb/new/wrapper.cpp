#include "tb/new/wrapper.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "model/core/input_error.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/verilog.h"
#include "tb/util/pattern.h"

namespace cosim::cli {
namespace {

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// Where the text goes on that is no blank.
std::size_t behind_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

}  // namespace

TopHead::TopHead(std::string_view text, const std::string& top) : top_(top) {
  try {
    read(text);
  } catch (const InputError& error) {
    wrong_ = error.what();
  }
}

void TopHead::read(std::string_view text) {
  const auto refused = [&](const char* why) {
    return InputError(fmt::format("--param: {}: {}: no wrapper can be written", top_, why));
  };
  const std::string plain = rtl::blanked(text);
  const Pattern begin(R"(\b(?:macro)?module\s+(?:automatic\s+|static\s+)?)" + top_ + R"(\b)");
  const std::vector<Pattern::Parts> found = begin.all(plain);
  if (found.empty()) throw refused("its head cannot be read");
  const std::string& word = found.front().front();
  const std::size_t from = plain.find(word) + word.size();
  const std::string_view head = std::string_view(plain).substr(from);
  std::size_t at = behind_blanks(head, 0);
  while (head.substr(at, 6) == "import" && at + 6 < head.size() && is_blank(head[at + 6])) {
    const std::size_t end = head.find(';', at);
    if (end == std::string_view::npos) throw refused("its head cannot be read");
    at = behind_blanks(head, end + 1);
  }
  const auto group = [&] {
    const bool is_one = at < head.size() && head[at] == '(';
    const std::size_t end = is_one ? rtl::group_end(head, at) : std::string_view::npos;
    if (end == std::string_view::npos) throw refused("its head cannot be read");
    const std::string_view list = head.substr(at + 1, end - at - 2);
    at = behind_blanks(head, end);
    return list;
  };
  if (at < head.size() && head[at] == '#') {
    at = behind_blanks(head, at + 1);
    const std::size_t list_at = at + 1;
    bool is_local = false, is_type = false;
    static const Pattern kind(R"(^(parameter|localparam)?\s*(type\b)?)");
    static const Pattern named(R"(([A-Za-z_]\w*)\s*(?:\[[^\]]*\]\s*)*$)");
    for (const rtl::Piece& item : rtl::parts(group(), list_at)) {
      const Pattern::Parts begins = kind.all(item.text).front();
      if (!begins[1].empty() || !begins[2].empty()) {
        is_local = begins[1] == "localparam";
        is_type = !begins[2].empty();
      }
      const std::size_t sign = std::min(item.text.find('='), item.text.size());
      const auto names = named.all(rtl::trimmed(item.text.substr(0, sign)));
      if (is_local || names.empty()) continue;
      const std::string& name = names.front()[1];
      items_[name] = {item.at + sign, item.at + item.text.size()};
      if (is_type) types_.insert(name);
    }
  }
  static const Pattern direction(R"(\b(?:input|output|inout)\b)");
  if (!direction.in(std::string(group()))) throw refused("the list of its ports has no types");
  text_ = std::string(text.substr(from, at));
}

std::string TopHead::wrapped(const std::string& name,
                             const std::map<std::string, std::string>& values) const {
  if (!wrong_.empty()) throw InputError(wrong_);
  static const Pattern is_written_out(R"(^\s*(?:struct|union|enum)\b)");
  std::string head = text_, given, types;
  std::vector<std::pair<Item, std::string>> edits;
  for (const auto& [parameter, value] : values) {
    const auto item = items_.find(parameter);
    if (item == items_.end()) {
      throw InputError(fmt::format("--param: {} has no parameter {}", top_, parameter));
    }
    const bool has_name = !is_written_out.in(value);
    edits.emplace_back(item->second,
                       " = " + (has_name ? value : fmt::format("{}_types::{}", name, parameter)));
    if (!has_name) types += fmt::format("  typedef {} {};\n", value, parameter);
  }
  std::ranges::sort(edits, [](const auto& a, const auto& b) { return a.first.end > b.first.end; });
  for (const auto& [item, text] : edits) head.replace(item.value, item.end - item.value, text);
  for (const auto& [parameter, item] : items_) {
    given += fmt::format("{}.{}({})", given.empty() ? "" : ", ", parameter, parameter);
  }
  // Verilator 5.006 ends in an internal error where such a type is itself the default.
  if (!types.empty()) types = fmt::format("package {}_types;\n{}endpackage\n", name, types);
  return types +
         fmt::format(
             "// {0} with parameters that are no numbers: its own head, with other defaults.\n"
             "module {1}{2};\n  {0}{3} dut (.*);\nendmodule\n",
             top_, name, head, given.empty() ? "" : " #(" + given + ")");
}

}  // namespace cosim::cli
