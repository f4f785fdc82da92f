// Operators in other words.
#include <algorithm>

#include "tests/pairs/write.h"

namespace cosim::pairs {
std::string Writer::unary(const Expr& e, Type context) {
  const Expr& a = e.args[0];
  const int width = type_of(a).width;
  if (e.op == "~" || e.op == "-" || e.op == "+") {
    const std::string x = expr(a, context);
    if (rarely(30) && e.op == "-") return "(~" + x + (context.is_signed ? " - 1'sb1)" : " + 1'b1)");
    if (rarely(30) && e.op == "~") return "(-" + x + (context.is_signed ? " + 1'sb1)" : " - 1'b1)");
    if (other_ && e.op == "+") return x;
    return '(' + e.op + x + ')';
  }
  const std::string x = expr(a), ones = repeated(width, "1'b1");
  const auto is = [&](const char* op) { return e.op == op; };
  if (rarely(60)) {
    if (is("&")) return "(~|(~" + x + "))";
    if (is("~&")) return "(|(~" + x + "))";
    // As wide as it is, and of its sign.
    const std::string zero =
        sized(std::string(static_cast<std::size_t>(width), '0'), type_of(a).is_signed);
    if (is("|")) return "(!(" + x + " == " + zero + "))";
    if (is("~|") || is("!")) return "(" + x + " == " + zero + ')';
  }
  if (rarely(60) && may_name && (is("^") || is("~^"))) {
    const std::string name = wired(a, type_of(a));
    std::string sum = is("^") ? "1'b0" : "1'b1";
    for (int i = 0; i < width; ++i)
      sum += " ^ " + name + (width == 1 ? "" : '[' + text_of(i) + ']');
    return '(' + sum + ')';
  }
  return '(' + e.op + x + ')';
}

std::string Writer::binary(const Expr& e, Type context) {
  if ((e.op == "/" || e.op == "%") && rarely(50) && may_name) return divided(e, context);
  std::string a = expr(e.args[0], context), b = expr(e.args[1], context);
  const auto is = [&](const char* op) { return e.op == op; };
  if (!is("-") && !is("/") && !is("%") && rarely(40)) std::swap(a, b);
  if (rarely(40)) {
    if (is("-")) return '(' + a + " + ~" + b + (context.is_signed ? " - 1'sb1)" : " + 1'b1)");
    if (is("+")) return '(' + a + " - (-" + b + "))";
    if (is("&")) return "(~(~" + a + " | ~" + b + "))";
    if (is("|")) return "(~(~" + a + " & ~" + b + "))";
    if (is("^")) return "((" + a + " & ~" + b + ") | (~" + a + " & " + b + "))";
    if (is("~^")) return "(~(" + a + " ^ " + b + "))";
  }
  return '(' + a + ' ' + e.op + ' ' + b + ')';
}

std::string Writer::compare(const Expr& e) {
  const Type type = common(type_of(e.args[0]), type_of(e.args[1]));
  std::string op = e.op;
  const bool is_equality = op[0] == '=' || op[0] == '!';
  if (rarely(35) && may_name) {
    const std::string a = wired(e.args[0], type), b = wired(e.args[1], type);
    if (is_equality) return (op[0] == '=' ? "(~|(" : "(|(") + a + " ^ " + b + "))";
    // Signed values are in order when their sign is the other way round.
    const std::string n = text_of(type.width - 1);
    const auto flipped = [&](const std::string& x) {
      return !type.is_signed ? "{1'b0, " + x + '}'
             : type.width == 1
                 ? "{1'b0, ~" + x + '}'
                 : "{1'b0, ~" + x + '[' + n + "], " + x + '[' +
                       (type.width == 2 ? "0" : text_of(type.width - 2) + ":0") + "]}";
    };
    const bool swaps = op[0] == '>', has_equal = op.size() == 2;
    const std::string x = flipped(swaps != has_equal ? b : a),
                      y = flipped(swaps != has_equal ? a : b);
    // x < y is the borrow of x - y, and x <= y is not y < x.
    const std::string borrow = wire({type.width + 1, false}, x + " - " + y);
    return '(' + std::string(has_equal ? "!" : "") + borrow + '[' + text_of(type.width) + "])";
  }
  const std::string a = expr(e.args[0], type), b = expr(e.args[1], type);
  if (op.size() == 3 && rarely(70)) op.pop_back();
  if (is_equality && rarely(40)) return '(' + b + ' ' + op + ' ' + a + ')';
  if (is_equality || !rarely(50)) return '(' + a + ' ' + op + ' ' + b + ')';
  const std::string inverse = op == "<" ? ">=" : op == "<=" ? ">" : op == ">" ? "<=" : "<";
  return "(!(" + a + ' ' + inverse + ' ' + b + "))";
}

std::string Writer::shift(const Expr& e, Type context) {
  if (rarely(60) && may_name) return staged(e, context);
  return '(' + expr(e.args[0], context) + ' ' + e.op + ' ' + expr(e.args[1]) + ')';
}

// A stage for each bit of the count that matters.
std::string Writer::staged(const Expr& e, Type context) {
  const int width = context.width, bits = type_of(e.args[1]).width;
  std::string now = wired(e.args[0], context);
  const std::string count = wired(e.args[1], {bits, type_of(e.args[1]).is_signed});
  const bool is_left = e.op[0] == '<', keeps_sign = e.op == ">>>" && context.is_signed;
  const auto bit = [&](const std::string& name, int i, int of) {
    return of == 1 ? name : name + '[' + text_of(i) + ']';
  };
  const std::string fill = keeps_sign ? bit(now, width - 1, width) : "1'b0";
  int stage = 0;
  for (; stage < bits && (1 << stage) < width; ++stage) {
    const int by = 1 << stage;
    const std::string filled = repeated(by, fill);
    const int first = is_left ? 0 : by, last = is_left ? width - by - 1 : width - 1;
    const std::string kept = now + '[' + text_of(last) + ':' + text_of(first) + ']';
    now = wire(context, bit(count, stage, bits) + " ? {" +
                            (is_left ? kept + ", " + filled : filled + ", " + kept) + "} : " + now);
  }
  if (stage == bits) return now;
  const std::string over =
      bits == 1 ? count : "(|" + count + '[' + text_of(bits - 1) + ':' + text_of(stage) + "])";
  return wire(context, over + " ? " + repeated(width, fill) + " : " + now);
}

// Signed: the quotient of the absolute values, and the signs behind it.
std::string Writer::divided(const Expr& e, Type context) {
  const std::string a = wired(e.args[0], context), b = wired(e.args[1], context);
  const Type positive{context.width, false};
  const std::string top = context.width == 1 ? "" : '[' + text_of(context.width - 1) + ']';
  const auto absolute = [&](const std::string& x) {
    return context.is_signed ? wire(positive, x + top + " ? -" + x + " : " + x) : x;
  };
  const std::string q = wire(positive, absolute(a) + ' ' + e.op + ' ' + absolute(b));
  if (!context.is_signed) return q;
  const std::string sign = e.op == "/" ? '(' + a + top + " ^ " + b + top + ')' : a + top;
  return wire(context, sign + " ? -" + q + " : " + q);
}

std::string Writer::power(const Expr& e, Type context) {
  const Type exponent = type_of(e.args[1]);
  if (!(rarely(70) && may_name) || exponent.width > 3) {
    return '(' + expr(e.args[0], context) + " ** " + expr(e.args[1]) + ')';
  }
  const std::string base = wired(e.args[0], context), n = wired(e.args[1], exponent);
  std::string product = wire(context, "1"), all = product;
  for (int i = 1; i < 1 << exponent.width; ++i) {
    product = wire(context, product + " * " + base);
    all = '(' + n + " == " + text_of(i) + " ? " + product + " : " + all + ')';
  }
  return all;
}

}  // namespace cosim::pairs
