// Blocks always @* whose functions read more than the block waits for.
#include <fmt/core.h>

#include <map>
#include <set>

#include "model/core/input_error.h"
#include "tb/equiv/misread.h"
#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::equiv {
namespace {

using Names = std::set<std::string>;

// The words that may be names; members and digits of numbers are none.
Names words_of(const std::string& text) {
  static const rtl::Regex word("(^|[^'.$`[:alnum:]_])([A-Za-z_][A-Za-z0-9_$]*)");
  Names names;
  for (const rtl::Match& one : word.all(text)) names.insert(one[2]);
  return names;
}

// What a text declares, but for parameters.
Names declared_in(const std::string& text) {
  static const std::string kinds = "(input|output|inout|reg|wire|logic|integer|bit|byte|int)";
  static const rtl::Regex constant("\\b(parameter|localparam|genvar)\\b[^;)]*"),
      no_name("\\[[^]]*\\]|=[^,;)]*|\\b(signed|unsigned|var)\\b|\\b" + kinds + "\\b"),
      declaration("\\b" + kinds + "\\b([^;)]*)");
  const std::string variables = constant.replaced(text, " ");
  Names names;
  for (const rtl::Match& one : declaration.all(variables)) {
    const Names more = words_of(no_name.replaced(one[2], " "));
    names.insert(more.begin(), more.end());
  }
  return names;
}

// What each function and task of a text reads of the module's signals, by those that it calls too.
std::map<std::string, Names> outer_signals(const std::string& plain) {
  static const rtl::Regex routine("\\b(function|task)\\b(([^;([]|\\[[^]]*\\])*)"),
      name_in("([A-Za-z_][A-Za-z0-9_$]*)\\s*$"), loop("\\bfor\\s*\\(\\s*(\\w+)\\s*=");
  std::string outside = plain;
  std::map<std::string, std::string> bodies;
  for (const rtl::Match& one : routine.all(plain)) {
    const std::size_t end = plain.find("end" + one[1], one.end());
    const std::string head = one[2];
    const rtl::Match name = name_in.find(head);
    if (end == std::string::npos || !name) continue;
    bodies[name[1]] += plain.substr(one.end(), end - one.end());
    blank(outside, one.begin(), end);
  }
  const Names signals = declared_in(outside);
  std::map<std::string, Names> read;
  for (const auto& [name, body] : bodies) {
    Names own = declared_in(body);
    for (const rtl::Match& one : loop.all(body)) own.insert(one[1]);
    for (const std::string& word : words_of(body)) {
      if (signals.contains(word) && !own.contains(word)) read[name].insert(word);
    }
  }
  for (std::size_t depth = 1; depth < bodies.size(); ++depth) {
    for (const auto& [name, body] : bodies) {
      for (const std::string& word : words_of(body)) {
        if (!bodies.contains(word)) continue;
        const Names more = read[word];
        read[name].insert(more.begin(), more.end());
      }
    }
  }
  return read;
}

}  // namespace

void refuse_deaf_blocks(const SourceText& source) {
  static const rtl::Regex block("\\balways\\s*@\\s*(\\*|\\(\\s*\\*\\s*\\))");
  const std::string plain = rtl::blanked(source.text);
  const auto blocks = block.all(plain);
  if (blocks.empty()) return;
  const auto read = outer_signals(plain);
  for (const rtl::Match& found : blocks) {
    const std::size_t end = behind_statement(plain, found.end(), true);
    const Names words = words_of(plain.substr(found.end(), end - found.end()));
    for (const auto& [name, signals] : read) {
      if (!words.contains(name)) continue;
      for (const std::string& signal : signals) {
        if (words.contains(signal)) continue;
        throw InputError(fmt::format(
            "{}: always @* does not wait for {}, which {} reads: make it an argument of that, or "
            "write always_comb",
            place_in(source, found.begin()), signal, name));
      }
    }
  }
}

}  // namespace cosim::equiv
