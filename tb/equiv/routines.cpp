// Functions and tasks that read or write signals of the module beside their arguments.
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
  static const rtl::Regex constant(
      "\\b(parameter|localparam|genvar)\\b[^;)]*|\\btypedef\\b[^;{]*(\\{[^}]*\\})?[^;]*;"),
      no_name("\\[[^]]*\\]|=[^,;)]*|\\b(signed|unsigned|var)\\b|\\b" + kinds + "\\b"),
      declaration("\\b" + kinds + "\\b([^;)]*)"), last("([A-Za-z_][A-Za-z0-9_$]*)\\s*(,|$)");
  const std::string variables = constant.replaced(text, " ");
  Names names;
  for (const rtl::Match& one : declaration.all(variables)) {
    // The last word of each: one before it is a type.
    const std::string all = no_name.replaced(one[2], " ");
    for (const rtl::Match& name : last.all(all)) names.insert(name[1]);
  }
  return names;
}

// The signals of a module that may change: no memories that only `initial` writes.
Names signals_in(const std::string& plain, const std::string& outside) {
  static const rtl::Regex declaration("\\b(reg|logic|integer|bit|byte|int)\\b([^;)]*);"),
      value("=[^,;]*"), memory("([A-Za-z_][A-Za-z0-9_$]*)\\s*\\["), initial("\\binitial\\b"),
      written("([A-Za-z_][A-Za-z0-9_$]*)\\s*(\\[[^];]*\\]\\s*)*<?=[^=]|\\.\\w+\\s*\\(\\s*(\\w+)");
  Names signals = declared_in(outside), constant;
  std::string running = plain;
  for (const rtl::Match& one : initial.all(plain)) {
    blank(running, one.begin(), behind_statement(plain, one.end(), true));
  }
  for (const rtl::Match& one : declaration.all(outside)) {
    const std::string names = value.replaced(one[2], "");
    for (const rtl::Match& name : memory.all(names)) constant.insert(name[1]);
  }
  for (const rtl::Match& one : written.all(running)) constant.erase(one[1] + one[3]);
  for (const std::string& name : constant) signals.erase(name);
  return signals;
}

// The names that a body assigns, but for those that it declares with a type of the user.
Names assigned_in(const std::string& body) {
  static const std::string begins = "(^|[;):]|\\b(begin|else|do)\\b)\\s*",
                           variable =
                               "(\\{[^{};=]*\\}|[A-Za-z_][A-Za-z0-9_$.]*(\\s*\\[[^;=]*\\])?)\\s*";
  static const rtl::Regex counts(begins + "(\\+\\+|--)\\s*" + variable),
      assignment(begins + "()" + variable + "([-+*/%&|^]?=[^=]|(<<<?|>>>?)=|\\+\\+|--)"),
      no_name("\\[[^]]*\\]|\\.\\w+"), word("\\b(begin|else|do|end\\w*|return)\\b"),
      declaration("([A-Za-z_]\\w*|\\])\\s+([A-Za-z_]\\w*)\\s*[;=,)]");
  Names assigned;
  for (const rtl::Regex* const form : {&counts, &assignment}) {
    for (const rtl::Match& one : form->all(body)) {
      const Names more = words_of(no_name.replaced(one[4], ""));
      assigned.insert(more.begin(), more.end());
    }
  }
  for (const rtl::Match& one : declaration.all(body)) {
    if (!word.find(one[1])) assigned.erase(one[2]);
  }
  return assigned;
}

// What a function or a task does with signals of the module.
struct Routine {
  bool has_value = false;
  std::string body;
  Names reads, writes;
};

std::map<std::string, Routine> routines_in(const std::string& plain) {
  static const rtl::Regex routine("\\b(function|task)\\b(([^;([]|\\[[^]]*\\])*)"),
      name_in("([A-Za-z_][A-Za-z0-9_$]*)\\s*$"), loop("\\bfor\\s*\\(\\s*(\\w+)\\s*="),
      none("\\bvoid\\b");
  std::string outside = plain;
  std::map<std::string, Routine> all;
  for (const rtl::Match& one : routine.all(plain)) {
    const std::size_t end = plain.find("end" + one[1], one.end());
    const std::string head = one[2];
    const rtl::Match name = name_in.find(head);
    if (end == std::string::npos || !name) continue;
    Routine& is = all[name[1]];
    is.has_value = one[1] == "function" && !none.find(head);
    is.body += plain.substr(one.end(), end - one.end());
    blank(outside, one.begin(), end);
  }
  if (all.empty()) return all;
  const Names signals = signals_in(plain, outside);
  for (auto& [name, is] : all) {
    Names own = declared_in(is.body);
    own.insert(name);
    for (const rtl::Match& one : loop.all(is.body)) own.insert(one[1]);
    const auto take = [&](const Names& words, Names& to) {
      for (const std::string& word : words) {
        if (signals.contains(word) && !own.contains(word)) to.insert(word);
      }
    };
    take(assigned_in(is.body), is.writes);
    own.insert(is.writes.begin(), is.writes.end());
    take(words_of(is.body), is.reads);
  }
  for (std::size_t depth = 1; depth < all.size(); ++depth) {
    for (auto& [name, is] : all) {
      for (const std::string& word : words_of(is.body)) {
        const auto called = all.find(word);
        if (called == all.end() || called->first == name) continue;
        is.reads.insert(called->second.reads.begin(), called->second.reads.end());
        is.writes.insert(called->second.writes.begin(), called->second.writes.end());
      }
    }
  }
  return all;
}

// What waits for the signals that its text names, and for no others.
void refuse_deaf(const SourceText& source, std::size_t at, const char* what,
                 const std::string& text, const std::map<std::string, Routine>& routines) {
  const Names words = words_of(text);
  for (const auto& [name, is] : routines) {
    if (!words.contains(name)) continue;
    for (const std::string& signal : is.reads) {
      if (words.contains(signal)) continue;
      throw InputError(
          fmt::format("{}: {} does not wait for {}, which {} reads: make it an argument of that, "
                      "or write always_comb",
                      place_in(source, at), what, signal, name));
    }
  }
}

// A function that writes a signal, where it is called in an expression: front ends take it as
// called wherever it stands, and not at all in what is printed or asserted.
void refuse_side_effects(const SourceText& source, const std::string& plain,
                         const std::map<std::string, Routine>& routines) {
  static const rtl::Regex whole("([^=!<>]=|<=|\\breturn|\\bvoid'\\()\\s*$"),
      heading("\\bfunction\\b[^;]*$"), end("^\\s*(\\)\\s*)?;");
  for (const auto& [name, is] : routines) {
    if (!is.has_value || is.writes.empty()) continue;
    const rtl::Regex call("\\b" + name + "\\s*\\(");
    for (const rtl::Match& found : call.all(plain)) {
      const std::size_t from = plain.find_last_of(';', found.begin()) + 1;
      const std::string before = plain.substr(from, found.begin() - from);
      const std::size_t behind = behind_arguments(plain, found.end() - 1);
      const bool is_whole = whole.find(before) && end.find(std::string_view(plain).substr(behind));
      if (is_whole || heading.find(before)) continue;
      throw InputError(
          fmt::format("{}: {} writes {}, and is called within an expression: front ends do not "
                      "read it as Verilog calls it; assign its value in a statement of its own",
                      place_in(source, found.begin()), name, *is.writes.begin()));
    }
  }
}

}  // namespace

void refuse_routines(const SourceText& source) {
  static const rtl::Regex block("\\balways\\s*@\\s*(\\*|\\(\\s*\\*\\s*\\))"),
      assignment("\\b(assign|wire\\b[^;=]*=)[^;]*;");
  const std::string plain = rtl::blanked(source.text);
  const auto routines = routines_in(plain);
  if (routines.empty()) return;
  for (const rtl::Match& found : block.all(plain)) {
    const std::size_t end = behind_statement(plain, found.end(), true);
    refuse_deaf(source, found.begin(), "always @*", plain.substr(found.end(), end - found.end()),
                routines);
  }
  for (const rtl::Match& found : assignment.all(plain)) {
    const char* what = found[1] == "assign" ? "assign" : "wire";
    refuse_deaf(source, found.begin(), what, found[0], routines);
  }
  refuse_side_effects(source, plain, routines);
}

}  // namespace cosim::equiv
