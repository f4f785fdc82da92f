// Statements, drawn.
#include <algorithm>

#include "tests/pairs/draw.h"

namespace cosim::pairs {

Stmt Draw::assignment(const Signal& target, bool whole) {
  Stmt s;
  const int width = target.type.width;
  if (!whole && target.is_vector && width > 2 && random_.percent(45)) {
    s.target = random_.percent(50) ? Target::part : Target::indexed;
    s.count = random_.between(1, std::min(width - 1, 6));
    s.low = random_.between(0, width - s.count);
    // A write beyond the end is a write of what is within.
    s.index = slice(random_.between(1, 4));
  }
  s.value = value(random_.between(1, 3));
  return s;
}

std::vector<Stmt> Draw::block(const Signal& target, int depth) {
  std::vector<Stmt> all;
  const int statements = random_.between(1, 2);
  for (int i = 0; i < statements; ++i) all.push_back(statement(target, depth));
  return all;
}

Stmt Draw::statement(const Signal& target, int depth) {
  Stmt s;
  const int kind = depth <= 0 ? 0 : random_.below(10);
  if (kind < 4) return assignment(target, false);
  if (kind < 6) {
    s.does = Does::branch;
    s.value = value(2);
    s.blocks = {block(target, depth - 1), {}};
    if (random_.percent(70)) s.blocks[1] = block(target, depth - 1);
    return s;
  }
  if (kind < 9) return choice(target, depth);
  s.does = Does::loop;
  s.word = name("k", loops_++);
  s.count = random_.between(2, 5);
  const Signal loop{s.word, {32, true}, 0, false, false, ""};
  scope_.push_back(loop);
  s.blocks = {{assignment(target, false)}};
  Stmt& body = s.blocks[0][0];
  if (random_.percent(60) && target.type.width > 2 && target.is_vector) {
    body.target = Target::indexed;
    body.count = random_.between(1, 3);
    body.index =
        random_.percent(50) ? use(loop) : make(Kind::binary, "*", {use(loop), number(body.count)});
  }
  if (random_.percent(70)) {
    body.value =
        make(Kind::binary, random_.of<std::string>({"+", "^", "-"}), {body.value, use(loop)});
  }
  scope_.pop_back();
  return s;
}

Stmt Draw::choice(const Signal& target, int depth) {
  Stmt s;
  s.does = Does::choose;
  s.word = random_.of<std::string>({"case", "case", "casez", "casex"});
  s.value = random_.percent(70) ? slice(random_.between(2, 4)) : value(1);
  const int width = std::min(type_of(s.value).width, 9);
  const bool is_signed = random_.percent(25);
  const int items = random_.between(1, 4);
  for (int i = 0; i < items; ++i) {
    const int more = random_.percent(85) ? 0 : random_.between(-1, 2);
    std::string bits = random_.bits(std::max(1, width + more));
    for (char& bit : bits) {
      if (!random_.percent(s.word == "case" ? 4 : 20)) continue;
      bit = s.word == "casez" ? (random_.percent(85) ? '?' : 'x') : random_.percent(50) ? 'x' : '?';
    }
    // How a wildcard at the left is extended with its sign is another question.
    const bool is_known = bits.find_first_not_of("01") == std::string::npos;
    s.items.push_back(constant(bits, is_signed && is_known));
    s.blocks.push_back(block(target, depth - 1));
  }
  s.blocks.emplace_back();
  if (random_.percent(70)) s.blocks.back() = block(target, depth - 1);
  return s;
}

std::vector<Stmt> Draw::body(const Signal& target, bool is_complete) {
  std::vector<Stmt> all;
  if (is_complete) {
    // A block that reads nothing would never run.
    all.push_back(assignment(target, true));
    all[0].value = make(Kind::binary, "^", {use(scope_.front()), all[0].value});
  }
  // Not before it has a value.
  scope_.push_back(target);
  const int statements = random_.between(1, 2);
  for (int i = 0; i < statements; ++i) all.push_back(statement(target, random_.between(1, 2)));
  scope_.pop_back();
  return all;
}

}  // namespace cosim::pairs
