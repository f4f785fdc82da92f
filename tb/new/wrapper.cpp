#include "tb/new/wrapper.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "model/core/input_error.h"
#include "tb/rtl/lexer.h"
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
    return InputError(fmt::format("{}: {}: no wrapper can be written", top_, why));
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
  const std::size_t ports_at = at + 1;
  const std::string ports(group());
  read_ports(rtl::parts(ports, ports_at));
  static const Pattern direction(R"(\b(?:input|output|inout)\b)");
  if (!direction.in(ports) && interfaces_.empty())
    throw refused("the list of its ports has no types");
  text_ = std::string(text.substr(from, at));
}

void TopHead::read_ports(const std::vector<rtl::Piece>& items) {
  static const Pattern of_modport(
      R"((?:([A-Za-z_]\w*)\s*\.\s*([A-Za-z_]\w*)\s+)?([A-Za-z_]\w*)\s*((?:\[[^\]]*\]\s*)*))"),
      named(R"(([A-Za-z_]\w*)\s*(?:\[[^\]]*\]\s*)*(?:=.*)?$)");
  bool is_in_interfaces = false;  // a name alone is of the kind of the one before it
  for (const rtl::Piece& item : items) {
    const Pattern::Parts one = of_modport.whole(item.text);
    is_in_interfaces = !one.empty() && (!one[1].empty() || is_in_interfaces);
    if (is_in_interfaces) {
      const bool is_first = !one[1].empty();
      interfaces_.push_back({is_first ? one[1] : interfaces_.back().interface,
                             is_first ? one[2] : interfaces_.back().modport, one[3], one[4],
                             item.at, item.at + item.text.size()});
    } else if (const auto names = named.all(item.text); !names.empty()) {
      pins_.insert(names.front()[1]);
    }
  }
}

std::string TopHead::wrapped(const std::string& name,
                             const std::map<std::string, std::string>& values,
                             const std::vector<OpenedPort>& opened) const {
  if (!wrong_.empty()) throw InputError(wrong_);
  static const Pattern is_written_out(R"(^\s*(?:struct|union|enum)\b)");
  std::string head = text_, given, types, body;
  std::vector<std::pair<Item, std::string>> edits;
  for (std::size_t i = 0; i < opened.size(); ++i) {
    const InterfacePort& port = interfaces_[i];
    edits.emplace_back(Item{port.at, port.end},
                       fmt::format("{}", fmt::join(opened[i].ports, ",\n    ")));
    body += opened[i].body;
  }
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
  return types + fmt::format(
                     "// {0} in its own head, {5}.\n"
                     "module {1}{2};\n{4}  {0}{3} dut (.*);\nendmodule\n",
                     top_, name, head, given.empty() ? "" : " #(" + given + ")", body,
                     opened.empty() ? "with other defaults"
                                    : "with the members of its interfaces as ports");
}

}  // namespace cosim::cli
