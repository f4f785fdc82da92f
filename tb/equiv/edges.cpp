// Asynchronous resets that are asked together with something else: `if (!rst_n || clear)`.
#include <set>
#include <string_view>
#include <vector>

#include "tb/equiv/front_end.h"
#include "tb/equiv/misread.h"
#include "tb/equiv/prints.h"
#include "tb/rtl/lexer.h"
#include "tb/rtl/regex.h"

namespace cosim::equiv {
namespace {

// The operands of || in an expression that is nothing else; one where it is something else.
std::vector<std::string> operands_of(const std::string& expression) {
  std::vector<std::string> operands(1);
  int depth = 0;
  for (std::size_t i = 0; i < expression.size(); ++i) {
    const char c = expression[i];
    depth += c == '(' || c == '[' || c == '{' ? 1 : c == ')' || c == ']' || c == '}' ? -1 : 0;
    if (depth == 0 && (c == '?' || expression.compare(i, 2, "->") == 0)) return {expression};
    if (depth == 0 && expression.compare(i, 2, "||") == 0) {
      operands.emplace_back();
      ++i;
    } else {
      operands.back() += c;
    }
  }
  return operands;
}

}  // namespace

std::string with_resets_apart(std::string text) {
  static const rtl::Regex block(
      "\\balways(_ff)?\\s*@\\s*\\(([^()]*)\\)\\s*(begin\\s*(:\\s*\\w+\\s*)?)?if\\s*\\("),
      edge("\\b(pos|neg)edge\\s+(\\w+)"), reset("^[ (!~]*(\\w+)\\s*(==\\s*1'[bB][01])?[ )]*$"),
      single("^\\s*(begin\\b|\\w+\\s*(\\[[^;=]*\\]\\s*)?<?=)"), named("\\bbegin\\s*:"),
      line_end("\\s+");
  const std::string plain = rtl::blanked(text);
  const std::vector<rtl::Match> blocks = block.all(plain);
  for (auto found = blocks.rbegin(); found != blocks.rend(); ++found) {
    const std::string events = (*found)[2];
    std::set<std::string> edges;
    for (const rtl::Match& one : edge.all(events)) edges.insert(one[2]);
    if (edges.size() < 2) continue;
    const std::size_t open = found->end() - 1, close = behind_arguments(plain, open);
    std::string first, others;
    const auto add = [](std::string& to, const std::string& one) {
      to += (to.empty() ? "" : " || ") + one;
    };
    const auto operands = operands_of(plain.substr(open + 1, close - open - 2));
    for (const std::string& operand : operands) {
      const rtl::Match is = reset.find(operand);
      add(first.empty() && is && edges.contains(is[1]) ? first : others, operand);
    }
    const std::size_t end = behind_statement(plain, close);
    const std::string statement = plain.substr(close, end - close);
    // A blanked text has no strings and no `ifdef.
    if (first.empty() || others.empty() || !single.find(statement) || named.find(statement) ||
        text.find_first_of("\"`", open) < end) {
      continue;
    }
    const std::string again = line_end.replaced(first + ") " + statement + " else if (", " ");
    text.replace(open + 1, close - open - 2, again + others);
  }
  return text;
}

}  // namespace cosim::equiv
