#include "tb/new/verilog_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "tb/rtl/lexer.h"

namespace cosim::cli {
namespace {

constexpr std::array begins{"module", "macromodule", "interface", "package", "program"};
constexpr std::array closing_words{"endmodule", "endinterface", "endpackage", "endprogram"};

template <class Words>
bool is_one_of(const Words& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

bool is_name(std::string_view word) {
  return !word.empty() &&
         (std::isalpha(static_cast<unsigned char>(word.front())) != 0 || word.front() == '_');
}

}  // namespace

VerilogText verilog_words(std::string_view text) {
  VerilogText found;
  found.units.emplace_back();
  rtl::Lexer lexer(text);
  std::size_t in = 0;  // the unit
  bool in_head = false, imports = false;
  int depth = 0;  // of brackets in the head
  std::string_view before, word = lexer.next();
  while (!word.empty()) {
    std::string_view next = lexer.next();
    if (in_head && word == "(" && depth++ == 0 && before != "#" && next != ")") {
      found.units[in].has_ports = true;
    } else if (in_head && word == ")") {
      --depth;
    } else if (in_head && word == ";" && depth == 0) {
      in_head = std::exchange(imports, false);
    }
    imports = imports || word == "import";
    if (word == "`include" && next.size() > 2) {
      found.headers.emplace_back(next.substr(1, next.size() - 2));
    } else if (before.starts_with("$readmem") && word == "(" && next.size() > 2) {
      found.data.emplace_back(next.substr(1, next.size() - 2));
    } else if (is_one_of(begins, word) && before != "virtual" && next != "class" &&
               (in == 0 || word == "package")) {
      const std::string_view kind = word;
      while (next == "automatic" || next == "static") next = lexer.next();
      found.units.push_back({std::string(next), kind == "package", kind.ends_with("module")});
      in = found.units.size() - 1;
      in_head = true;
      imports = false;
      depth = 0;
    } else if (is_one_of(closing_words, word)) {
      in = 0;
    } else if (is_name(word) &&
               (is_name(next) || next == "#" || next == "::" || next == "." || next == "\\")) {
      found.units[in].uses.emplace(word);
    }
    before = word;
    word = next;
  }
  return found;
}

VerilogText vhdl_words(std::string_view text) {
  std::string small;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text.substr(at, 2) == "--") at = std::min(text.find('\n', at), text.size() - 1);
    small += static_cast<char>(std::tolower(static_cast<unsigned char>(text[at])));
  }
  VerilogText found;
  found.units.emplace_back();
  rtl::Lexer lexer(small);
  bool in_entity = false;
  // "entity x is", "use work.x", "entity work.x" and "x port map".
  for (std::array<std::string_view, 4> w{"", "", "", lexer.next()}; !w[1].empty() || !w[3].empty();
       w = {w[1], w[2], w[3], lexer.next()}) {
    if ((w[1] == "entity" || w[1] == "package") && w[3] == "is") {
      in_entity = w[1] == "entity";
      found.units.push_back({std::string(w[2]), w[1] == "package", in_entity});
    } else if (in_entity && w[2] == "port" && w[3] == "(") {
      found.units.back().has_ports = true;
    } else if (w[3] == "end") {
      in_entity = false;
    } else if ((w[0] == "use" || w[0] == "entity") && w[2] == ".") {
      found.units.front().uses.emplace(w[3]);
    } else if (w[3] == "map" && is_name(w[1])) {
      found.units.front().uses.emplace(w[1]);
    }
  }
  return found;
}

}  // namespace cosim::cli
