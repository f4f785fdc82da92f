#include "tb/proof/rtl.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string_view>

#include "model/core/input_error.h"
#include "tb/proof/first_word.h"
#include "tb/proof/steps.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"

namespace cosim::proof {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFormulas = "rtl.smt2";

int width_of(const std::string& sort) {
  return sort == boolean ? 1 : std::stoi(sort.substr(sort.find_last_of(' ')));
}

// Yosys defines a function of the state for every wire; here the state is what the free symbols
// are, and the functions are plain names.
std::string without_state(const std::string& text) {
  static const Pattern applied(R"(\((\|[^|]*\|) state\))");
  return applied.replaced(text, "$1");
}

// What makes of assertions formulas of their own clock. A yosys from 0.38 on has cells of another
// kind for them at first.
std::string commands_for_assertions() {
  static const bool has_checks = [] {
    std::istringstream words(run_program({"yosys", "-V"}).text);
    std::string name;
    int major = 0, minor = 0;
    char point = 0;
    words >> name >> major >> point >> minor;
    return major > 0 || minor >= 38;
  }();
  return has_checks ? "chformal -lower; chformal -early; opt_clean" : "chformal -early; opt_clean";
}

}  // namespace

// What is undefined is free in the formula.
std::string formula_commands(const Source& source, const fs::path& folder) {
  return step_commands(source, folder) + "; async2sync; " + commands_for_assertions() +
         "; dffunmap; setundef -anyseq; write_smt2 -wires " + (folder / kFormulas).string();
}
Rtl formulas_in(const fs::path& folder, const Source& source) {
  return {source.top, read_file((folder / kFormulas).string()), source.asynchronous_reset};
}

Rtl::Rtl(std::string top, const std::string& smt2, bool asynchronous_reset)
    : top_(std::move(top)), asynchronous_reset_(asynchronous_reset) {
  std::istringstream lines(smt2);
  for (std::string line; std::getline(lines, line);) read_line(line);
  if (free_.empty()) throw InputError(top_ + ": yosys wrote no machine");
}

void Rtl::read_line(const std::string& line) {
  static const Pattern declaration(R"(\(declare-fun (\|[^|]*\|) \(\|[^|]*\|\) (.*)\) ;.*)");
  static const Pattern relation(R"(  \(= (.*) \((\|[^|]*\|) next_state\)\).*)");
  static const Pattern function(
      R"(\(define-fun (\|[^|]*\|) \(\(state \|[^|]*\|\)\) (Bool|\(_ BitVec \d+\)) (.*)\)( ;.*)?)");
  Pattern::Parts part;
  if (line.starts_with(';')) return read_port(line);
  if (in_initial_) {  // a line "  (= term value) ; name" for each register, perhaps in an (and
    in_initial_ = !line.starts_with(')');
    const std::size_t begin = line.find("(= "), end = line.find(" ;");
    if (in_initial_ && begin != std::string::npos) {
      initial_.push_back(without_state(line.substr(begin, end - begin)));
    }
    return;
  }
  if (line.starts_with("(define-fun |" + top_ + "_t|")) {
    in_relation_ = true;
  } else if (line.starts_with("(define-fun |" + top_ + "_i|") && !line.ends_with(')')) {
    in_initial_ = true;
  } else if (in_relation_ && !(part = relation.whole(line)).empty()) {
    const auto found = std::find_if(free_.begin(), free_.end(),
                                    [&](const Free& f) { return f.symbol == part[2]; });
    if (found == free_.end()) throw InputError(top_ + ": a register that yosys did not declare");
    found->after = without_state(part[1]);
  } else if (!in_relation_ && !(part = declaration.whole(line)).empty()) {
    free_.push_back({part[1], width_of(part[2]), part[2] == boolean, ""});
  } else if (!in_relation_ && !(part = function.whole(line)).empty()) {
    define(part[1], part[2], without_state(part[3]));
  }
}

// "; yosys-smt2-KIND NAME ...". A clock's line stands behind its own as an input.
void Rtl::read_port(const std::string& line) {
  std::istringstream words(line.substr(1));
  std::string kind, name;
  words >> kind >> name;
  if (kind == "yosys-smt2-input") inputs_.push_back(name);
  if (kind == "yosys-smt2-output") outputs_.push_back(name);
  if (kind == "yosys-smt2-clock") std::erase(inputs_, name);
}

void Rtl::define(const std::string& name, const std::string& sort, const std::string& body) {
  if (name == "|" + top_ + "_u|" && body != "true") {
    throw InputError(top_ + ": its Verilog assumes something");
  }
  if (name.starts_with("|" + top_ + "_a ")) asserted_.emplace_back(name, sort);
  definitions_ += definition(name, sort, body);
  wires_[name] = {sort, body};
}

std::vector<std::size_t> Rtl::pieces(const std::string& wire) const {
  static const Pattern word(
      R"(\(concat |\(= \(\(_ extract 0 0\) |\) #b1\)|\(ite | #b1 #b0\)|\|[^|]*\|| |\)+)");
  std::vector<std::size_t> found;
  const auto of = wires_.find(fmt::format("|{}_n {}|", top_, wire));
  if (of == wires_.end()) return {};
  const std::string& body = of->second.body;
  std::size_t read = 0;
  for (const Pattern::Parts& part : word.all(body)) {
    read += part[0].size();
    if (!part[0].starts_with('|')) continue;
    const std::string seen = asynchronous_reset_ ? without_reset(part[0]) : part[0];
    const auto symbol =
        std::find_if(free_.begin(), free_.end(), [&](const Free& f) { return f.symbol == seen; });
    if (symbol == free_.end()) return {};
    found.push_back(static_cast<std::size_t>(symbol - free_.begin()));
  }
  if (read != body.size()) return {};  // there is something else in it
  return found;
}

// Yosys makes of a register with an asynchronous reset one without, and behind it a choice between
// that and a constant, by the input.
std::string Rtl::without_reset(const std::string& symbol) const {
  // An input that is nothing but a condition is a Bool.
  static const Pattern choice(
      R"(\(ite (?:\|[^|]*\||\(= \(\(_ extract 0 0\) \|[^|]*\|\) #b1\)) (\S+) (\S+)\))");
  const auto of = wires_.find(symbol);
  if (of == wires_.end()) return symbol;
  const Pattern::Parts part = choice.whole(of->second.body);
  if (part.empty()) return symbol;
  const std::string &chosen = part[1], &other = part[2];
  const auto is_constant = [](const std::string& term) {
    return term.starts_with("#b") || term == "true" || term == "false";
  };
  if (is_constant(chosen) && other.starts_with('|')) return other;
  if (is_constant(other) && chosen.starts_with('|')) return chosen;
  return symbol;
}

std::string on_next_clock(const std::string& text) {
  static const Pattern symbol(R"(\|([^|]*)\|)");
  return symbol.replaced(text, "|$1'|");
}

Expression on_next_clock(const Expression& term) {
  if (term.parts().empty()) return {on_next_clock(term.text()), term.sort()};
  std::vector<Expression> parts;
  for (const Expression& p : term.parts()) parts.push_back(on_next_clock(p));
  return {term.text(), term.sort(), parts};
}

std::optional<Choice> Rtl::choice(const std::string& symbol) const {
  auto of = wires_.find(symbol);
  const Wire* wire = nullptr;
  for (; of != wires_.end(); of = wires_.find(wire->body)) wire = &of->second;
  constexpr std::string_view head = "(ite ";
  if (wire == nullptr || wire->sort == boolean || !wire->body.starts_with(head)) return {};
  const std::string_view body(wire->body);
  std::vector<std::string> parts;
  int depth = 0;
  bool is_quoted = false;
  for (std::size_t begin = head.size(), i = begin; i < body.size(); ++i) {
    if (body[i] == '|') is_quoted = !is_quoted;
    if (is_quoted) continue;
    if (depth == 0 && (body[i] == ' ' || body[i] == ')')) {
      parts.emplace_back(body.substr(begin, i - begin));
      begin = i + 1;
    }
    depth += body[i] == '(' ? 1 : body[i] == ')' ? -1 : 0;
  }
  return Choice{{parts.at(0), boolean}, {parts.at(1), wire->sort}, {parts.at(2), wire->sort}};
}

int Rtl::first_word(const std::string& memory) const {
  return proof::first_word(wires_, fmt::format("|{}_n {}[", top_, memory));
}

int Rtl::width(const std::string& wire) const {
  const auto of = wires_.find(fmt::format("|{}_n {}|", top_, wire));
  return of == wires_.end() ? 0 : width_of(of->second.sort);
}

Expression Rtl::wire(const std::string& name) const {
  const std::string symbol = fmt::format("|{}_n {}|", top_, name);
  const auto of = wires_.find(symbol);
  if (of == wires_.end()) throw InputError(fmt::format("{}: no output {}", top_, name));
  return as_code({symbol, of->second.sort});
}

Expression as_code(const Expression& term) {
  if (term.sort() != boolean) return term;
  const std::string bit = bit_vector(1);
  return {"ite", bit, {term, {"#b1", bit}, {"#b0", bit}}};
}

Expression as_sort(const Expression& code, const std::string& sort) {
  if (sort != boolean) return code;
  return equal(code, {"#b1", bit_vector(1)});
}

}  // namespace cosim::proof
