// SU 1631518: a line from its start to its end, at every width that is shipped. Position q >= 1 of
// a line belongs to bit i of the code, a_i, where q = 2^(i-1) * odd.
#include <array>

#include "tb/designs/linear/design.h"
#include "tb/designs/linear/proof/theorems.h"
#include "tb/nets/exported.h"

namespace cosim::linear {
namespace {

using namespace proof;
using nets::Number, nets::Truth;

// What the registers hold: triggers 30, 31 and 32, counter 4, register 5, multiplier 6, registers 3
// and 9, trigger 10.
using Held = std::array<Number, 9>;
// initial_set_n, reset, write_bp, write_uk, start, data.
using Pins = std::array<Number, 6>;
Pins at_rest() { return {1, 0, 0, 0, 0, 0}; }

struct Clock {
  Held after;
  std::array<Number, 4> out;  // busy, strobe, minor, major
};
Clock clock_of(const Sizes& sizes, const Held& held, const Pins& pins) {
  Design::State<Number> state;
  Design::Inputs<Number> in;
  for_each_cell<decltype(state)>([&](auto cell, std::size_t i) { cell(state) = held[i]; });
  for_each_cell<decltype(in)>([&](auto cell, std::size_t i) { cell(in) = pins[i]; });
  const auto step = Design::next(Design::shape_of({sizes.m, sizes.n}), state, in);
  Clock clock;
  for_each_cell<Design::State<Number>>(
      [&](auto cell, std::size_t i) { clock.after[i] = cell(step.state); });
  for_each_cell<Design::Outputs<Number>>(
      [&](auto cell, std::size_t i) { clock.out[i] = cell(step.outputs); });
  return clock;
}

Sizes sizes_in(const Widths& widths) { return {widths[0].value, widths[1].value}; }

Truth same(const Held& a, const Held& b) {
  Truth all = true;
  for (std::size_t i = 0; i < a.size(); ++i) all = all & (a[i] == b[i]);
  return all;
}

// Whether minor steps at position q: the bit of the code that it belongs to.
Truth belongs(const Sizes& sizes, const Number& code, const Number& q) {
  Truth any = false;
  for (int i = 1; i <= sizes.m; ++i) {
    const Truth here = low_bits(q, i) == Number(cosim::shift_left(1, i - 1));
    any = any | (here & bit(code, sizes.m - i));
  }
  return any;
}

// The machine without a line: only the code is left.
Held without_line(const Sizes& sizes, const Number& code) {
  Number pattern(0);
  for (int q = 1; q < sizes.word(); ++q) {
    pattern = shift_left(pattern, 1) + Number(belongs(sizes, code, Number(q)));
  }
  return {0, 0, 0, 0, 0, 0, low_bits(code, sizes.n), pattern, 0};
}

// Any line anywhere on its way: T words are put out of BP positions with the code C; the next word
// is formed, or not yet.
struct Line {
  Number bp, words, code, formed;

  static Line any(const Sizes& sizes, FreeNumbers& free) {
    return {free.number("BP", sizes.m), free.number("T", sizes.n + 1), free.number("C", sizes.m),
            free.number("formed", 1)};
  }
  Truth is_left(const Sizes& sizes) const { return bp > shift_left(words, sizes.gamma()); }
  // Before the first word none is put out; behind that each has positions.
  Truth holds(const Sizes& sizes) const {
    return is_left(sizes) & ((words == Number(0)) | is_set(formed));
  }
  Held held(const Sizes& sizes) const {
    const Number all = shift_right(bp + Number(sizes.word() - 1), sizes.gamma());
    const Truth last = belongs(sizes, code, shift_left(words + Number(1), sizes.gamma()));
    Held h = without_line(sizes, code);
    h[0] = formed;
    h[1] = h[2] = Number(1);
    h[3] = all - words - formed;
    h[4] = low_bits(bp, sizes.gamma());
    h[5] = low_bits(words + formed, sizes.n);
    h[8] = Number(last & is_set(formed));
    return h;
  }
};

// From a machine at rest, whatever code it keeps: two writes and a start, and a clock more.
Truth line_begins(const Widths& widths, FreeNumbers& free) {
  const Sizes sizes = sizes_in(widths);
  const Number bp = free.number("BP", sizes.m), code = free.number("C", sizes.m);
  Held held{};
  held[6] = free.number("register3", sizes.n);
  held[7] = free.number("register9", sizes.word() - 1);
  std::array<Pins, 4> pins;
  pins.fill(at_rest());
  pins[0][2] = pins[1][3] = pins[2][4] = Number(1);
  pins[0][5] = bp;
  pins[1][5] = code;

  Held started;
  Truth strobe = false;
  for (const Pins& in : pins) {
    started = held;  // in the end what the start left
    const Clock clock = clock_of(sizes, held, in);
    strobe = strobe | is_set(clock.out[1]);
    held = clock.after;
  }
  const Truth begun = same(started, Line{bp, Number(0), code, Number(0)}.held(sizes));
  const Truth over = same(held, without_line(sizes, code)) | (bp > Number(0));
  return strobe | !(begun & over);
}

// The strobe is up: the words hold positions T 2^gamma + 1 and on.
Truth words_hold(const Widths& widths, FreeNumbers& free) {
  const Sizes sizes = sizes_in(widths);
  const Line line = Line::any(sizes, free);
  free.assume(line.holds(sizes) & is_set(line.formed));
  const auto [busy, strobe, minor, major] = clock_of(sizes, line.held(sizes), at_rest()).out;
  const Number before = shift_left(line.words, sizes.gamma());
  Truth wrong = !is_set(strobe);
  for (int q = 1; q <= sizes.word(); ++q) {
    const Number position = before + Number(q);
    const Truth in_line = !(position > line.bp);
    const Truth steps = in_line & belongs(sizes, line.code, position);
    wrong =
        wrong | (bit(major, sizes.word() - q) ^ in_line) | (bit(minor, sizes.word() - q) ^ steps);
  }
  return wrong;
}

// A clock: the next word is formed after this one, or the line ends with no position left.
Truth words_follow(const Widths& widths, FreeNumbers& free) {
  const Sizes sizes = sizes_in(widths);
  const Line line = Line::any(sizes, free);
  free.assume(line.holds(sizes));
  const Held after = clock_of(sizes, line.held(sizes), at_rest()).after;
  const Line next{line.bp, line.words + line.formed, line.code, Number(1)};
  const Truth goes_on = next.is_left(sizes) & same(after, next.held(sizes));
  const Truth ends = same(after, without_line(sizes, line.code)) & !next.is_left(sizes);
  return !(goes_on | ends);
}

}  // namespace

std::vector<proof::Theorem> word_theorems() {
  const auto theorem = [](const char* sentence, Truth (*wrong)(const Widths&, FreeNumbers&)) {
    return at_every_width(Design::name, sentence, wrong);
  };
  return {
      theorem("at every shipped width BP and UK written and a start put a machine at rest before "
              "the first of BP positions; a line of none ends there, with no word",
              line_begins),
      theorem("at every shipped width, position q of the word after T words is position "
              "T 2^gamma + q of the line: major steps there if that is at most BP, and "
              "minor if moreover its bit of the code is set",
              words_hold),
      theorem("at every shipped width word follows word on every clock until no position is "
              "left, and then the machine is at rest: so major gets BP steps",
              words_follow)};
}

}  // namespace cosim::linear
