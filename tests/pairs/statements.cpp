// Statements, as they are or as chains of conditions; and flat: a wire for each assignment.
#include <algorithm>

#include "tests/pairs/write.h"

namespace cosim::pairs {
namespace {

// Of the selector and all items, which are widened to each other.
Type compared(const Stmt& s) {
  Type type = type_of(s.value);
  for (const Expr& item : s.items) type = common(type, item.type);
  return type;
}

}  // namespace

std::string loop_variables(const std::vector<Stmt>& body, const std::string& indent) {
  std::string all;
  for (const Stmt& s : body) {
    if (s.does == Does::loop) all += indent + "integer " + s.word + ";\n";
    for (const auto& block : s.blocks) all += loop_variables(block, indent);
  }
  return all;
}

// The condition of an item: where it has wildcards, of the other bits.
std::string Writer::matches(const Stmt& s, std::size_t i) {
  const Type type = compared(s);
  std::string bits = s.items[i].bits, mask;
  const char sign = type.is_signed ? bits[0] : '0';
  bits.insert(0, static_cast<std::size_t>(type.width) - bits.size(), sign);
  for (char& bit : bits) {
    const bool is_z = bit == '?' || bit == 'z', is_x = bit == 'x';
    if ((is_x && s.word != "casex") || (is_z && s.word == "case")) return "1'b0";
    mask += is_x || is_z ? '0' : '1';
    if (is_x || is_z) bit = '0';
  }
  const std::string value = expr(s.value, type);
  if (mask.find('0') == std::string::npos)
    return '(' + value + " == " + sized(bits, type.is_signed) + ')';
  return "((" + value + " & " + sized(mask) + ") == " + sized(bits) + ')';
}

// The items as an enum where they can be one: "e_" of e_0, e_1 and so on.
std::string Writer::labels(const Stmt& s) {
  if (!may_declare) return "";
  const std::string name = fresh("e") + '_';
  std::string all;
  for (std::size_t i = 0; i < s.items.size(); ++i) {
    const Expr& item = s.items[i];
    if (item.bits.find_first_not_of("01") != std::string::npos || item.type.is_signed ||
        item.type.width != s.items[0].type.width || all.find(item.bits) != std::string::npos) {
      return "";
    }
    all += (i == 0 ? "" : ", ") + name + std::to_string(i) + " = " + sized(item.bits);
  }
  lines +=
      "  typedef enum logic " + range(s.items[0].type.width) + '{' + all + "} " + name + "t;\n";
  return name;
}

std::string Writer::target_of(const Stmt& s, const Signal& target) {
  return s.target == Target::whole  ? whole(target.name)
         : s.target == Target::part ? select(target.name, s.low, s.count)
                                    : indexed(target.name, s.index, s.count);
}

std::string Writer::statements(const std::vector<Stmt>& body, const Signal& target,
                               const std::string& gets, const std::string& indent) {
  std::string all;
  const std::string deeper = indent + "  ";
  const auto block = [&](const std::vector<Stmt>& inner) {
    return "begin\n" + statements(inner, target, gets, deeper) + indent + "end\n";
  };
  for (const Stmt& s : body) {
    switch (s.does) {
      case Does::assign: {
        const int width = s.target == Target::whole ? target.type.width : s.count;
        all += indent + target_of(s, target) + ' ' + gets + ' ' + assigned(s.value, width) + ";\n";
        break;
      }
      case Does::branch: {
        const std::string condition = truth(s.value);
        if (rarely(40)) {
          all += indent + "if (!(" + condition + ")) " + block(s.blocks[1]) + indent + "else " +
                 block(s.blocks[0]);
          break;
        }
        all += indent + "if (" + condition + ") " + block(s.blocks[0]);
        if (!s.blocks[1].empty()) all += indent + "else " + block(s.blocks[1]);
        break;
      }
      case Does::choose: {
        if (rarely(70)) {
          std::string head = "if (";
          for (std::size_t i = 0; i < s.items.size(); ++i) {
            all += indent + head + matches(s, i) + ") " + block(s.blocks[i]);
            head = "else if (";
          }
          all += indent + "else " + block(s.blocks.back());
          break;
        }
        all += indent + s.word + " (" + expr(s.value, compared(s)) + ")\n";
        const std::string label = labels(s);
        for (std::size_t i = 0; i < s.items.size(); ++i) {
          all += indent + (label.empty() ? literal(s.items[i]) : label + std::to_string(i)) + ": " +
                 block(s.blocks[i]);
        }
        all += indent + "default: " + block(s.blocks.back()) + indent + "endcase\n";
        break;
      }
      case Does::loop: {
        Signal loop{s.word, {32, true}, 0, false, false, ""};
        if (rarely(60)) {
          for (int i = 0; i < s.count; ++i) {
            loop.text = "32'sd" + text_of(i);
            scope[s.word] = loop;
            all += statements(s.blocks[0], target, gets, indent);
          }
          break;
        }
        scope[s.word] = loop;
        const std::string count =
            design_.is_sv && !other_ ? s.word + "++" : s.word + " = " + s.word + " + 1";
        all += indent + "for (" + s.word + " = 0; " + s.word + " < " + text_of(s.count) + "; " +
               count + ") " + block(s.blocks[0]);
        break;
      }
    }
  }
  return all;
}

std::string Writer::flat(const std::vector<Stmt>& body, const Signal& target, std::string now,
                         bool at_once) {
  const Type type = target.type;
  const std::string zeros = sized(std::string(static_cast<std::size_t>(type.width), '0'));
  for (const Stmt& s : body) {
    if (at_once) scope[target.name] = {now, type, 0, false, true, ""};
    switch (s.does) {
      case Does::assign: {
        if (s.target == Target::whole) {
          now = wire(type, assigned(s.value, type.width));
          break;
        }
        const std::string value = wire({s.count, false}, assigned(s.value, s.count));
        const std::string at =
            s.target == Target::part ? text_of(s.low) : wired(s.index, type_of(s.index));
        const std::string ones = sized(std::string(static_cast<std::size_t>(s.count), '1'));
        const std::string mask =
            wire({type.width, false}, '{' + zeros + ", " + ones + "} << " + at);
        const std::string moved =
            wire({type.width, false}, '{' + zeros + ", " + value + "} << " + at);
        now = wire(type, '(' + now + " & ~" + mask + ") | (" + moved + " & " + mask + ')');
        break;
      }
      case Does::branch: {
        const std::string condition = wire({}, '|' + truth(s.value));
        const std::string yes = flat(s.blocks[0], target, now, at_once);
        const std::string no = flat(s.blocks[1], target, now, at_once);
        now = wire(type, condition + " ? " + yes + " : " + no);
        break;
      }
      case Does::choose: {
        std::vector<std::string> conditions, values;
        for (std::size_t i = 0; i < s.items.size(); ++i) {
          if (at_once) scope[target.name] = {now, type, 0, false, true, ""};
          conditions.push_back(wire({}, matches(s, i)));
          values.push_back(flat(s.blocks[i], target, now, at_once));
        }
        std::string all = flat(s.blocks.back(), target, now, at_once);
        for (std::size_t i = conditions.size(); i-- > 0;) {
          all = conditions[i] + " ? " + values[i] + " : (" + all + ')';
        }
        now = wire(type, all);
        break;
      }
      case Does::loop:
        for (int i = 0; i < s.count; ++i) {
          scope[s.word] = {s.word, {32, true}, 0, false, false, "32'sd" + text_of(i)};
          now = flat(s.blocks[0], target, now, at_once);
        }
        break;
    }
  }
  return now;
}

std::string Writer::inlined(const Function& f, const std::vector<Expr>& actual) {
  std::map<std::string, Signal> inner;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const Signal& formal = f.arguments[i];
    const std::string name = wire(formal.type, assigned(actual[i], formal.type.width));
    inner[formal.name] = {name, formal.type, 0, false, true, ""};
  }
  inner.swap(scope);
  const std::string zeros = sized(std::string(static_cast<std::size_t>(f.result.type.width), '0'));
  std::string result = flat(f.body, f.value, zeros, true);
  inner.swap(scope);
  return result;
}

}  // namespace cosim::pairs
