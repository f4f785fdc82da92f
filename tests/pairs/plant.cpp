// One change of a design: an operator, a constant, a sign, a position, a branch, a reset.
#include <algorithm>
#include <utility>

#include "tests/pairs/design.h"

namespace cosim::pairs {
namespace {

struct Places {
  std::vector<Expr*> exprs;
  std::vector<Stmt*> stmts;

  void of(Expr& e) {
    exprs.push_back(&e);
    for (Expr& arg : e.args) of(arg);
  }
  void of(std::vector<Stmt>& body) {
    for (Stmt& s : body) {
      stmts.push_back(&s);
      of(s.value);
      if (s.target == Target::indexed) of(s.index);
      for (Expr& item : s.items) of(item);
      for (auto& block : s.blocks) of(block);
    }
  }
  void of(Design& design) {
    for (Function& f : design.functions) of(f.body);
    for (Item& item : design.items) {
      of(item.value);
      of(item.body);
      for (Write& write : item.writes) of(write.enable), of(write.address), of(write.data);
      for (Argument& port : item.ports) of(port.actual);
      for (Argument& parameter : item.parameters) of(parameter.actual);
    }
  }
};

using Family = std::vector<std::string>;

std::string swapped(Expr& e, Random& random) {
  static const std::vector<Family> families{
      {"+", "-"},   {"&", "|", "^", "~^"}, {"<", "<=", ">", ">="},
      {"==", "!="}, {"<<", ">>", ">>>"},   {"&&", "||"},
      {"/", "%"},   {"~&", "~|", "!"},     {"$signed", "$unsigned"}};
  const bool is_unary = e.kind == Kind::unary;
  for (const Family& family : families) {
    if (std::find(family.begin(), family.end(), e.op) == family.end()) continue;
    // & | ^ of one operand make one bit, - and ~ do not.
    std::string op = is_unary && (e.op == "-" || e.op == "+") ? "~" : random.of(family);
    if (op == e.op) return "";
    return std::exchange(e.op, op) + " is " + op;
  }
  if (is_unary && e.op == "~") return e.op = "-", "~ is -";
  return "";
}

std::string change(Expr& e, Random& random) {
  switch (e.kind) {
    case Kind::constant: {
      if (e.bits.empty()) return "";  // a loop has no value
      const bool has_sign = e.op != "unsized" && random.percent(25);
      if (has_sign && e.bits.find_first_not_of("01") == std::string::npos) {
        e.type.is_signed = !e.type.is_signed;
        return "sign of " + e.bits;
      }
      const std::string was = e.bits;
      const std::size_t first = e.op == "unsized" ? e.bits.size() - 3 : 0;
      const std::size_t at =
          first + static_cast<std::size_t>(random.below(static_cast<int>(e.bits.size() - first)));
      e.bits[at] = e.bits[at] == '0' ? '1' : '0';
      return was + " is " + e.bits;
    }
    case Kind::name: {
      const Expr was = e;
      e = Expr();
      e.kind = Kind::cast;
      e.op = was.type.is_signed ? "$unsigned" : "$signed";
      e.args = {was};
      return "sign of " + was.op;
    }
    case Kind::part:
      if (e.low == 0) return "";
      --e.low;
      return "position in " + e.op;
    case Kind::ternary:
      std::swap(e.args[1], e.args[2]);
      return "branches of ?:";
    case Kind::concat:
      if (e.args.size() == 1) return "";
      std::swap(e.args[0], e.args[1]);
      return "order in { }";
    default:
      return swapped(e, random);
  }
}

std::string change(Stmt& s, Random& random) {
  if (s.does == Does::branch) return std::swap(s.blocks[0], s.blocks[1]), "branches of if";
  if (s.does == Does::loop) return --s.count, "bound of " + s.word;
  if (s.does == Does::choose) {
    if (random.percent(50)) {
      const std::string was = std::exchange(s.word, s.word == "case" ? "casez" : "case");
      return was + " is " + s.word;
    }
    std::swap(s.blocks[0], s.blocks[1]);
    return "items of " + s.word;
  }
  if (s.target == Target::part && s.low > 0) return --s.low, "position that is written";
  return "";
}

std::string change(Item& item, Random& random) {
  if (item.is == Is::clocked) {
    const int kind = random.below(3);
    if (kind == 0 && item.how != Reset::none) {
      item.how = item.how == Reset::synchronous ? Reset::asynchronous : Reset::synchronous;
      return "kind of reset of " + item.target.name;
    }
    char& bit = item.initial.back();
    if (kind == 1) return bit = bit == '0' ? '1' : '0', "first value of " + item.target.name;
  }
  if (item.is == Is::memory) {
    if (item.writes.size() > 1) return std::swap(item.writes[0], item.writes[1]), "order of writes";
    Write& write = item.writes[0];
    if (write.low > 0) return --write.low, "position that is written";
  }
  return "";
}

}  // namespace

std::string plant(Design& design, Random& random) {
  Places places;
  places.of(design);
  std::string what;
  for (int tries = 0; what.empty() && tries < 1000; ++tries) {
    const int kind = random.below(10);
    if (kind < 6)
      what = change(*random.of(places.exprs), random);
    else if (kind < 8 && !places.stmts.empty())
      what = change(*random.of(places.stmts), random);
    else {
      const int i = random.below(static_cast<int>(design.items.size()));
      what = change(design.items[static_cast<std::size_t>(i)], random);
    }
  }
  return what;
}

}  // namespace cosim::pairs
