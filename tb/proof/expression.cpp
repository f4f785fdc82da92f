#include "tb/proof/expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace cosim::proof {
namespace {

constexpr std::string_view kDeclare = "(declare-const ", kAssert = "(assert ",
                           kEquation = "(assert (= ", kCheck = "(check-sat)";

// Calls defined(name, sort, term) for what definition() wrote, and other(line) for all other lines.
template <class Defined, class Other>
void read_script(std::string_view left, const Defined& defined, const Other& other) {
  const auto take_line = [&] {
    const std::string_view line = left.substr(0, left.find('\n'));
    left.remove_prefix(std::min(line.size() + 1, left.size()));
    return line;
  };
  while (!left.empty()) {
    const std::string_view line = take_line();
    // "NAME SORT": a sort is "Bool" or in parentheses.
    const std::string_view both = line.substr(std::min(line.size(), kDeclare.size()));
    const std::size_t sort = std::min(both.rfind(" ("), both.rfind(' '));
    const std::string head = fmt::format("{}{} ", kEquation, both.substr(0, sort));
    if (line.starts_with(kDeclare) && left.starts_with(head)) {
      const std::string_view term = take_line().substr(head.size());
      defined(both.substr(0, sort), both.substr(sort + 1, both.size() - sort - 2),
              term.substr(0, term.size() - 2));
    } else {
      other(line);
    }
  }
}

}  // namespace

std::string bit_vector(int width) { return fmt::format("(_ BitVec {})", width); }

Expression truth(bool value) { return {value ? "true" : "false", boolean}; }
Expression negation(const Expression& a) { return {"not", boolean, {a}}; }
Expression conjunction(const Expression& a, const Expression& b) {
  return {"and", boolean, {a, b}};
}
Expression disjunction(const Expression& a, const Expression& b) { return {"or", boolean, {a, b}}; }
Expression equal(const Expression& a, const Expression& b) { return {"=", boolean, {a, b}}; }

std::string definition(const std::string& name, const std::string& sort, const std::string& term) {
  return fmt::format("{0}{1} {2})\n{3}{1} {4}))\n", kDeclare, name, sort, kEquation, term);
}

std::string with_definitions(const std::string& script) {
  std::string text;
  read_script(
      script,
      [&](std::string_view name, std::string_view sort, std::string_view term) {
        text += fmt::format("(define-fun {} () {} {})\n", name, sort, term);
      },
      [&](std::string_view line) { text += fmt::format("{}\n", line); });
  return text;
}

std::string with_lets(const std::string& script) {
  std::string head, lets, asserted, ends;
  std::size_t count = 0;
  read_script(
      script,
      [&](std::string_view name, std::string_view, std::string_view term) {
        lets += fmt::format("(let (({} {}))\n", name, term);
        ++count;
      },
      [&](std::string_view line) {
        if (line.starts_with(kAssert)) {
          const std::string_view term = line.substr(kAssert.size());
          asserted += fmt::format(" {}", term.substr(0, term.size() - 1));
        } else {
          (line.starts_with(kCheck) ? ends : head) += fmt::format("{}\n", line);
        }
      });
  return fmt::format("{}{}{}(and true{}){})\n{}", head, kAssert, lets, asserted,
                     std::string(count, ')'), ends);
}

Script::Script(const std::string& logic)
    : text_(fmt::format("(set-option :produce-models true)\n(set-logic {})\n", logic)) {}

Expression Script::declare(const std::string& name, const std::string& sort) {
  text_ += fmt::format("(declare-const {} {})\n", name, sort);
  return {name, sort};
}

Expression Script::define(const std::string& name, const Expression& value) {
  const std::string text = name_of(value);
  text_ += definition(name, value.sort(), text);
  return {name, value.sort()};
}

void Script::assume(const Expression& condition) {
  const std::string text = name_of(condition);
  text_ += fmt::format("(assert {})\n", text);
}

void Script::ask(const Expression& also) {
  assume(also);
  text_ += "(check-sat)\n";
}

void Script::ask_apart(const Expression& also) {
  const std::string name = name_of(also);
  text_ += fmt::format("(push 1)\n(assert {})\n(check-sat)\n(pop 1)\n", name);
}

std::string Script::name_of(const Expression& e) {
  if (e.parts().empty()) return e.text();
  if (const auto found = named_.find(e.identity()); found != named_.end()) return found->second;
  std::string text = '(' + e.text();
  for (const Expression& part : e.parts()) text += ' ' + name_of(part);
  text += ')';
  auto [same, is_new] = same_.try_emplace(text, fmt::format("t{}", same_.size()));
  if (is_new) text_ += definition(same->second, e.sort(), text);
  named_.emplace(e.identity(), same->second);
  kept_.push_back(e);
  return same->second;
}

}  // namespace cosim::proof
