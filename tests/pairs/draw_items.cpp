// Ports, functions and what drives each signal, drawn.
#include <algorithm>

#include "tests/pairs/draw.h"

namespace cosim::pairs {

Design Draw::all() {
  ports();
  const int functions = random_.percent(50) ? 0 : random_.between(1, 2);
  for (int i = 0; i < functions; ++i) design_.functions.push_back(function(i));
  const int items = random_.between(1, 4);
  for (int i = 0; i < items; ++i) item(i);
  // What no output shows would not be compared.
  Item last = net("last", {random_.between(1, 8), false}, {});
  last.is_output = true;
  for (const Item& one : design_.items) {
    if (one.is_output) continue;
    Expr sum;
    sum.kind = Kind::binary;
    sum.op = "^";
    Expr all;
    all.kind = Kind::unary;
    all.op = "^";
    if (one.is == Is::memory) continue;
    all.args = {use(one.target)};
    sum.args = {last.value, all};
    last.value = sum;
  }
  design_.items.push_back(last);
  return design_;
}

void Draw::ports() {
  const int clocks = random_.percent(60) ? 1 : random_.between(1, 2);
  for (int i = 0; i < clocks; ++i) {
    design_.clocks.push_back({clocks == 1 ? "clk" : name("clk", i), random_.percent(20)});
  }
  const int resets = random_.below(3);
  for (int i = 0; i < resets; ++i) {
    const std::string reset = resets == 1 ? "rst" : name("rst", i);
    design_.resets.push_back({random_.percent(40) ? reset + "_n" : reset, {}, 0, false, false, ""});
  }
  const int inputs = random_.between(2, 5);
  for (int i = 0; i < inputs; ++i) design_.inputs.push_back(signal(name("i", i), type()));
  scope_ = design_.inputs;
}

Function Draw::function(int i) {
  const std::vector<Signal> outer = scope_;
  Function f;
  f.result = {name("f", i), type(), 0, false, true, ""};
  const int arguments = random_.between(1, 3);
  scope_.clear();
  for (int k = 0; k < arguments; ++k) scope_.push_back(signal(name("a", k), type()));
  f.arguments = scope_;
  can_call_ = false;
  f.value = f.result;
  f.value.name = name("v", i);
  f.body = body(f.value, true);
  can_call_ = true;
  scope_ = outer;
  return f;
}

Item Draw::net(const std::string& name, Type type, std::vector<Stmt> body) {
  Item item;
  item.target = signal(name, type);
  item.value = value(3);
  item.body = std::move(body);
  item.is_output = random_.percent(60);
  return item;
}

void Draw::clocked(Item& item) {
  item.clock = random_.below(static_cast<int>(design_.clocks.size()));
  if (!design_.resets.empty() && random_.percent(80)) {
    item.how = random_.percent(50) ? Reset::synchronous : Reset::asynchronous;
    item.reset = random_.below(static_cast<int>(design_.resets.size()));
  }
  item.initial = random_.bits(item.target.type.width);
}

void Draw::memory(int i) {
  Item item;
  item.is = Is::memory;
  item.target = {name("m", i), {random_.between(1, 9), random_.percent(20)}, 0, false, true, ""};
  item.words = random_.between(2, 9);
  item.clock = random_.below(static_cast<int>(design_.clocks.size()));
  item.from_file = random_.percent(40);
  for (int k = 0; k < item.words; ++k)
    item.contents.push_back(random_.bits(item.target.type.width));
  int bits = 1;
  while ((1 << bits) < item.words) ++bits;
  const int writes = random_.between(1, 2);
  for (int k = 0; k < writes; ++k) {
    Write write{value(1), slice(bits), value(2), 0, item.target.type.width};
    if (random_.percent(35)) {
      write.count = random_.between(1, item.target.type.width);
      write.low = random_.between(0, item.target.type.width - write.count);
    }
    item.writes.push_back(write);
  }
  design_.items.push_back(item);
  const int reads = random_.between(1, 2);
  for (int k = 0; k < reads; ++k) {
    const Expr address = slice(bits);
    Expr word = make(Kind::word, item.target.name, {address});
    word.type = item.target.type;
    Item read = net(name(item.target.name + "_read", k), item.target.type, {});
    read.value = word;
    if ((1 << bits) > item.words) {
      read.value = make(Kind::ternary, "",
                        {make(Kind::compare, "<", {address, number(item.words)}), word,
                         constant(random_.bits(2), item.target.type.is_signed)});
    }
    add(read);
  }
}

void Draw::add(const Item& item) {
  design_.items.push_back(item);
  scope_.push_back(item.target);
}

void Draw::item(int i) {
  switch (random_.below(12)) {
    case 0:
    case 1:
      return add(net(name("w", i), type(), {}));
    case 2: {
      Item one = net(name("w", i), {}, {});
      one.value = heavy(one.target.type);
      return add(one);
    }
    case 3:
    case 4: {
      Item one = net(name("c", i), type(), {});
      one.is = Is::comb;
      one.body = body(one.target, true);
      return add(one);
    }
    case 5:
    case 6:
    case 7:
    case 8: {
      Item one = net(name("r", i), type(), {});
      one.is = Is::clocked;
      clocked(one);
      one.body = body(one.target, false);
      return add(one);
    }
    case 9:
      return memory(i);
    case 10:
      return instance(i);
    default:
      return generate(i);
  }
}

void Draw::instance(int i) {
  Item one = net(name("s", i), type(), {});
  one.is = Is::instance;
  const std::vector<Signal> outer = scope_;
  std::vector<Signal> inner;
  const int inputs = random_.between(1, 2);
  for (int k = 0; k < inputs; ++k) {
    const Signal formal{name("p", k), type(), 0, false, true, ""};
    // Whether the port widens an expression is told in two ways: it has a width of its own here.
    Expr actual = random_.percent(40) ? use(random_.of(outer)) : make(Kind::concat, "", {value(2)});
    if (actual.kind == Kind::concat) unsized(actual.args[0]);
    one.ports.push_back({formal, actual, true});
    inner.push_back(formal);
  }
  const int parameters = random_.below(3);
  for (int k = 0; k < parameters; ++k) {
    const bool has_type = random_.percent(40);
    const Expr given = random_.percent(40)
                           ? number(random_.below(40))
                           : constant(random_.bits(random_.between(1, 9)), random_.percent(50));
    const Type own{random_.between(2, 9), random_.percent(50)};
    const Signal formal{name("P", k), has_type ? own : type_of(given), 0, false, false, ""};
    one.parameters.push_back({formal, given, has_type});
    inner.push_back(formal);
  }
  scope_ = inner;
  const bool called = std::exchange(can_call_, false);
  one.value = value(3);
  can_call_ = called;
  scope_ = outer;
  add(one);
}

void Draw::generate(int i) {
  Item one = net(name("g", i), {}, {});
  one.is = Is::generate;
  one.turns = random_.between(2, 6);
  const int count = random_.between(1, 4);
  one.target.type = {one.turns * count, random_.percent(30)};
  one.loop = name("turn", i);
  one.value = value(2);
  // A genvar has no size, so it may not stand within { }.
  if (random_.percent(80)) {
    const Signal loop{one.loop, {32, true}, 0, false, false, ""};
    one.value =
        make(Kind::binary, random_.of<std::string>({"+", "^", "-"}), {one.value, use(loop)});
  }
  add(one);
}

Design random_design(Random& random, bool is_sv) { return Draw(random, is_sv).all(); }

}  // namespace cosim::pairs
