#include "tb/proof/expression.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

namespace cosim::proof {
namespace {

constexpr std::string_view kDefine = "(define-fun ", kOfNothing = " () ", kAssert = "(assert ",
                           kCheck = "(check-sat)";

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
  return fmt::format("{}{}{}{} {})\n", kDefine, name, kOfNothing, sort, term);
}

std::string with_lets(const std::string& script) {
  std::string head, lets, asserted, ends;
  std::size_t count = 0;
  const auto rest_of = [](std::string_view line, std::size_t first) {
    return line.substr(first, line.size() - first - 1);  // without the parenthesis at its end
  };
  for (std::string_view left = script; !left.empty();) {
    const std::string_view line = left.substr(0, left.find('\n'));
    left.remove_prefix(std::min(line.size() + 1, left.size()));
    if (line.starts_with(kDefine)) {
      const std::size_t of_nothing = line.find(kOfNothing), sort = of_nothing + kOfNothing.size();
      const std::size_t sort_end =
          line[sort] == '(' ? line.find(')', sort) + 1 : line.find(' ', sort);
      lets +=
          fmt::format("(let (({} {}))\n", line.substr(kDefine.size(), of_nothing - kDefine.size()),
                      rest_of(line, sort_end + 1));
      ++count;
    } else if (line.starts_with(kAssert)) {
      asserted += fmt::format(" {}", rest_of(line, kAssert.size()));
    } else {
      (line.starts_with(kCheck) ? ends : head) += fmt::format("{}\n", line);
    }
  }
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
