// Expressions. A text that takes the place of an operand has its sign and no more than the
// context's width, or it would change how the others are widened.
#include "tests/pairs/write.h"

#include <algorithm>

namespace cosim::pairs {

std::string text_of(long value) { return std::to_string(value); }

std::string repeated(int count, const std::string& what) {
  return '{' + text_of(count) + '{' + what + "}}";
}

std::string range(int width) { return width == 1 ? "" : '[' + std::to_string(width - 1) + ":0] "; }

std::string range(const Signal& s) {
  if (!s.is_vector) return "";
  if (s.type.width == 1 && s.low == 0) return "";
  const std::string low = std::to_string(s.low), high = std::to_string(s.low + s.type.width - 1);
  return '[' + (s.ascending ? low + ':' + high : high + ':' + low) + "] ";
}

std::string sized(const std::string& bits, bool is_signed) {
  return std::to_string(bits.size()) + (is_signed ? "'sb" : "'b") + bits;
}

namespace {

std::string name_sign(Type type) { return type.is_signed ? "signed " : ""; }

}  // namespace

std::string Writer::fresh(const std::string& stem) { return stem + std::to_string(names_++); }

std::string Writer::declared(const std::string& kind, const Signal& s) const {
  return kind + ' ' + name_sign(s.type) + range(s) + s.name;
}

std::string Writer::wire(Type type, const std::string& text) {
  const std::string name = fresh("n");
  lines += "  wire " + name_sign(type) + range(type.width) + name + " = " + text + ";\n";
  return name;
}

std::string Writer::wired(const Expr& e, Type context) {
  std::string text = expr(e, context);
  // Within an unsigned context a signed operand is extended with zeros; alone it would not be.
  if (!context.is_signed && type_of(e).is_signed) text = "1'b0 | " + text;
  return wire(context, text);
}

std::string Writer::assigned(const Expr& e, int width) {
  const Type own = type_of(e);
  if (may_declare && e.kind == Kind::constant && e.op.empty() && random_.percent(50)) {
    const bool is_filled = own.width >= width || e.bits[0] == '0';
    if (is_filled && e.bits.find(e.bits[0] == '0' ? '1' : '0') == std::string::npos) {
      return std::string("'") + e.bits[0];
    }
  }
  return expr(e, {std::max(own.width, width), own.is_signed});
}

// A member of a struct that the signal is assigned to.
std::string Writer::member(const std::string& name, int low, int count) {
  const std::string copy = fresh("n");
  const int above = scope.at(name).type.width - low - count;
  lines += "  struct packed {\n";
  if (above > 0) lines += "    logic " + range(above) + "above;\n";
  lines += "    logic " + range(count) + "field;\n";
  if (low > 0) lines += "    logic " + range(low) + "below;\n";
  lines += "  } " + copy + ";\n  assign " + copy + " = " + whole(name) + ";\n";
  return copy + ".field";
}

std::string Writer::whole(const std::string& name) const {
  const Signal& s = scope.at(name);
  return s.text.empty() ? s.name : s.text;
}

std::string Writer::part(const std::string& name, int low, int count) {
  if (rarely(15) && may_name) return wire({count, false}, whole(name) + " >> " + text_of(low));
  if (may_declare && random_.percent(25)) return member(name, low, count);
  return select(name, low, count);
}

std::string Writer::select(const std::string& name, int low, int count) {
  const Signal& s = scope.at(name);
  if (s.type.width == 1 && range(s).empty()) return whole(name);
  const int right = s.ascending ? s.low + s.type.width - 1 - low : s.low + low;
  const int left = s.ascending ? right - count + 1 : right + count - 1;
  if (count == 1) return whole(name) + '[' + text_of(right) + ']';
  if (random_.percent(15)) {
    return whole(name) + '[' +
           (random_.percent(50) == s.ascending ? text_of(left) + (s.ascending ? " +: " : " -: ")
                                               : text_of(right) + (s.ascending ? " -: " : " +: ")) +
           text_of(count) + ']';
  }
  return whole(name) + '[' + text_of(left) + ':' + text_of(right) + ']';
}

std::string Writer::indexed(const std::string& name, const Expr& position, int count) {
  const Signal& s = scope.at(name);
  const Type wide = common(type_of(position), {32, true});
  const bool plain = s.low == 0 && !s.ascending;
  const std::string at = plain ? expr(position)
                         : s.ascending
                             ? text_of(s.low + s.type.width - 1) + " - " + expr(position, wide)
                             : text_of(s.low) + " + " + expr(position, wide);
  if (count == 1) return whole(name) + '[' + at + ']';
  return whole(name) + '[' + at + (s.ascending ? " -: " : " +: ") + text_of(count) + ']';
}

std::string Writer::literal(const Expr& e) {
  const std::string sign = e.type.is_signed ? "s" : "";
  const int width = e.type.width;
  if (e.op == "unsized" && !rarely(50)) {
    return std::to_string(std::stoull(e.bits, nullptr, 2));
  }
  const std::string head = std::to_string(width) + '\'' + sign;
  const bool is_known = e.bits.find_first_not_of("01") == std::string::npos;
  const int base = is_known ? random_.below(4) : 0;
  if (base == 1 && width < 63) return head + 'd' + std::to_string(std::stoull(e.bits, nullptr, 2));
  if (base >= 2) {
    std::string digits,
        bits = std::string(static_cast<std::size_t>((4 - width % 4) % 4), '0') + e.bits;
    for (std::size_t i = 0; i < bits.size(); i += 4) {
      digits += "0123456789abcdef"[std::stoul(bits.substr(i, 4), nullptr, 2)];
    }
    return head + 'h' + digits;
  }
  return head + 'b' + e.bits;
}

std::string Writer::expr(const Expr& e, Type context) {
  const bool is_leaf = e.kind == Kind::name || e.kind == Kind::constant || e.kind == Kind::part;
  if (other_ && may_name && !is_leaf && random_.percent(12)) {
    return wired(e, context);
  }
  switch (e.kind) {
    case Kind::constant:
      return literal(e);
    case Kind::name:
      return whole(e.op);
    case Kind::part:
      return part(e.op, e.low, e.count);
    case Kind::indexed: {
      if (rarely(40) && may_name) {
        return wire({e.count, false}, whole(e.op) + " >> " + wired(e.args[0], type_of(e.args[0])));
      }
      return indexed(e.op, e.args[0], e.count);
    }
    case Kind::word: {
      if (opened.count(e.op) == 0) return e.op + '[' + expr(e.args[0]) + ']';
      const std::string at = wired(e.args[0], type_of(e.args[0]));
      std::string all = word_of(e.op, 0);
      for (int i = 1; i < opened.at(e.op); ++i) {
        all = at + " == " + text_of(i) + " ? " + word_of(e.op, i) + " : " + all;
      }
      return wire(e.type, all);
    }
    case Kind::unary:
      return unary(e, context);
    case Kind::binary:
      return binary(e, context);
    case Kind::compare:
      return compare(e);
    case Kind::logical: {
      const std::string a = truth(e.args[0]), b = truth(e.args[1]);
      if (rarely(30)) return "(!(!" + a + (e.op == "&&" ? " || !" : " && !") + b + "))";
      if (rarely(30)) return "((|" + a + ") " + e.op[0] + " (|" + b + "))";
      return '(' + a + ' ' + e.op + ' ' + b + ')';
    }
    case Kind::shift:
      return shift(e, context);
    case Kind::power:
      return power(e, context);
    case Kind::ternary: {
      const std::string c = truth(e.args[0]), a = expr(e.args[1], context),
                        b = expr(e.args[2], context);
      if (rarely(25)) return "(!" + c + " ? " + b + " : " + a + ')';
      if (rarely(25) && may_name) {
        const std::string mask = wire({context.width, false}, repeated(context.width, "|" + c));
        return wire(context, '(' + mask + " & " + wired(e.args[1], context) + ") | (~" + mask +
                                 " & " + wired(e.args[2], context) + ')');
      }
      return '(' + c + " ? " + a + " : " + b + ')';
    }
    case Kind::concat: {
      std::string all;
      for (const Expr& arg : e.args) all += (all.empty() ? "" : ", ") + expr(arg);
      return '{' + all + '}';
    }
    case Kind::replicate: {
      if (!rarely(50)) return repeated(e.count, expr(e.args[0]));
      std::string all;
      for (int i = 0; i < e.count; ++i) all += (i == 0 ? "" : ", ") + expr(e.args[0]);
      return '{' + all + '}';
    }
    case Kind::cast:
      return e.op + '(' + expr(e.args[0]) + ')';
    case Kind::size: {
      // What is within has its own width.
      if (rarely(80) && may_name) return wire(type_of(e), wired(e.args[0], type_of(e.args[0])));
      return std::to_string(e.count) + "'(" + expr(e.args[0]) + ')';
    }
    case Kind::call: {
      const auto f = std::find_if(design_.functions.begin(), design_.functions.end(),
                                  [&](const Function& one) { return one.result.name == e.op; });
      if (rarely(60) && may_name) return inlined(*f, e.args);
      std::string all;
      for (std::size_t i = 0; i < e.args.size(); ++i) {
        all += (i == 0 ? "" : ", ") + assigned(e.args[i], f->arguments[i].type.width);
      }
      return e.op + '(' + all + ')';
    }
  }
  return "";
}

std::string Writer::truth(const Expr& e) {
  if (rarely(20)) return "(|" + expr(e) + ')';
  return expr(e);
}

}  // namespace cosim::pairs
