// The reader of BTOR2, line by line.
#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "model/core/input_error.h"
#include "tb/nets/btor2.h"
#include "tb/nets/words.h"
#include "tb/util/words.h"

namespace cosim::nets {
namespace {

constexpr int kMostBits = 4096;

class Btor2Reader {
  using Widths = Btor2::Operation::Widths;

 public:
  explicit Btor2Reader(const std::string& file) : file_(file) {}

  Btor2 read(std::string_view text) {
    for (const std::string& line : lines_in(text)) {
      ++line_;
      words_ = words_in(line);
      words_.erase(std::ranges::find_if(words_, [](auto& w) { return w[0] == ';'; }), words_.end());
      at_ = 0;
      if (!words_.empty()) read_line();
    }
    for (std::size_t i = 0; i < next_.size(); ++i) {
      line_ = state_lines_[i];
      if (!next_[i])
        fail(fmt::format("state {} has no next value", in_quotes(model_.states[i].name)));
      model_.next.push_back(*next_[i]);
    }
    return std::move(model_);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(fmt::format("{}:{}: {}", file_, line_, why));
  }

  // The next word of the line.
  const std::string& word(const char* what) {
    if (at_ == words_.size()) fail(fmt::format("{} is missing at the end of the line", what));
    return words_[at_++];
  }
  int number(const char* what, int least, int most) {
    const std::string& text = word(what);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < least || value > most) {
      fail(fmt::format("{} is {}, not a number from {} to {}", what, in_quotes(text), least, most));
    }
    return value;
  }
  int line_number(const char* what) { return number(what, 1, kMostLines); }
  // The width of a sort.
  int sort() {
    const auto at = sorts_.find(line_number("the sort"));
    if (at == sorts_.end()) fail(fmt::format("{} is not the number of a sort", words_[at_ - 1]));
    return at->second;
  }
  // A node, or the inverse of one.
  std::uint32_t node() {
    const int given = number("the operand", -kMostLines, kMostLines);
    const auto at = nodes_.find(std::abs(given));
    if (at == nodes_.end()) {
      fail(fmt::format("{} is not the number of a value above", words_[at_ - 1]));
    }
    if (given > 0) return at->second;
    const Btor2::Node& of = model_.nodes[at->second];
    if (!of.constant.empty()) return add({.width = of.width, .constant = inverted(of.constant)});
    return add({.operation = operation_of("not"), .width = of.width, .of = {at->second}});
  }
  std::uint32_t add(Btor2::Node node) {
    model_.nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(model_.nodes.size() - 1);
  }
  static std::string bits(int width) { return count(static_cast<std::uint64_t>(width), "bit"); }
  void end() const {
    if (at_ < words_.size()) fail(fmt::format("{} is one word too many", in_quotes(words_[at_])));
  }
  // The next word as a name that no other `what` has.
  Btor2::Name named(const std::string& what, std::uint32_t node) {
    const std::string& name = word("the name");
    if (!names_.emplace(what, name).second) {
      fail(fmt::format("a second {} is named {}", what, in_quotes(name)));
    }
    return {name, model_.nodes[node].width, node};
  }

  void read_line() {
    const int id = line_number("the line's number");
    const std::string kind = word("what the line is");
    if (!ids_.insert(id).second) fail(fmt::format("a second line has the number {}", id));
    if (kind == "sort") {
      if (const std::string& sort = word("the kind of sort"); sort != "bitvec") {
        fail(fmt::format("sort {} is not supported, only bitvec", in_quotes(sort)));
      }
      sorts_[id] = number("the width", 1, kMostBits);
    } else if (kind == "input") {
      nodes_[id] = add({.width = sort()});
      model_.inputs.push_back(named(kind, nodes_[id]));
    } else if (kind == "state") {
      nodes_[id] = add({.width = sort()});
      model_.states.push_back(named(kind, nodes_[id]));
      model_.init.emplace_back();
      next_.emplace_back();
      state_lines_.push_back(line_);
    } else if (kind == "output") {
      model_.outputs.push_back(named(kind, node()));
    } else if (kind == "init" || kind == "next") {
      read_value_of_state(kind);
    } else {
      nodes_[id] = add(value(kind));
      if (at_ < words_.size()) ++at_;  // it may have a name
    }
    end();
  }

  void read_value_of_state(const std::string& kind) {
    const int width = sort();
    const std::uint32_t of = node(), value = node();
    const auto state = std::ranges::find(model_.states, of, &Btor2::Name::node);
    if (state == model_.states.end()) fail(fmt::format("{}: {} is not a state", kind, words_[3]));
    if (state->width != width || model_.nodes[value].width != width) {
      fail(fmt::format("{} of {}: state {} has {}, its value {}", kind, bits(width),
                       in_quotes(state->name), state->width, model_.nodes[value].width));
    }
    const auto i = static_cast<std::size_t>(state - model_.states.begin());
    if (kind == "init" ? model_.init[i].has_value() : next_[i].has_value()) {
      fail(fmt::format("a second {} of state {}", kind, in_quotes(state->name)));
    }
    if (kind == "next") {
      next_[i] = value;
      return;
    }
    const Bits& code = model_.nodes[value].constant;
    if (code.empty()) fail(fmt::format("init: {} is not a constant", words_[4]));
    std::vector<bool>& init = model_.init[i].emplace();
    for (const Bit bit : code) init.push_back(bit == yes);
  }

  Btor2::Node value(const std::string& kind) {
    const Btor2::Operation* operation = operation_of(kind);
    if (operation == nullptr) return constant(kind);
    Btor2::Node made{.operation = operation, .width = sort()};
    std::array<int, 3> widths{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(operation->operands); ++i) {
      made.of[i] = node();
      widths[i] = model_.nodes[made.of[i]].width;
    }
    if (!fits(made, widths)) {
      std::string all;
      for (int i = 0; i < operation->operands; ++i) {
        all += fmt::format("{}{}", i == 0 ? "" : ", ", widths[static_cast<std::size_t>(i)]);
      }
      fail(fmt::format("{} of {}: the widths of its operands, {}, do not fit", kind,
                       bits(made.width), all));
    }
    return made;
  }
  // Whether the widths are those of the operation; reads the numbers that follow the operands.
  bool fits(Btor2::Node& made, const std::array<int, 3>& of) {
    const int width = made.width;
    switch (made.operation->widths) {
      case Widths::same:
        return of[0] == width && (made.operation->operands == 1 || of[1] == width);
      case Widths::comparison:
        return width == 1 && of[0] == of[1];
      case Widths::choice:
        return of[0] == 1 && of[1] == width && of[2] == width;
      case Widths::joined:
        return of[0] + of[1] == width;
      case Widths::slice: {
        const int high = number("the highest bit", 0, of[0] - 1);
        made.low = number("the lowest bit", 0, high);
        return high - made.low + 1 == width;
      }
      case Widths::extended:
        return of[0] + number("the number of bits added", 0, kMostBits) == width;
    }
    return false;
  }

  Btor2::Node constant(const std::string& kind) {
    static const std::map<std::string, int> bases{{"const", 2}, {"constd", 10}, {"consth", 16}};
    const auto base = bases.find(kind);
    if (base == bases.end() && kind != "zero" && kind != "one" && kind != "ones") {
      fail(fmt::format("{} is not supported in a golden model", in_quotes(kind)));
    }
    const int width = sort();
    Bits code(static_cast<std::size_t>(width), nets::constant(kind == "ones"));
    if (kind == "one") code[0] = yes;
    if (base != bases.end() && !digits(word("the value"), base->second, code)) {
      fail(fmt::format("{} is not a number of base {} that fits {}", in_quotes(words_[at_ - 1]),
                       base->second, bits(width)));
    }
    return {.width = width, .constant = std::move(code)};
  }
  // The value of the digits in `code`, which are 0; one of base 10 may have a sign.
  static bool digits(std::string_view text, int base, Bits& code) {
    const bool is_minus = base == 10 && text.starts_with('-');
    if (is_minus) text.remove_prefix(1);
    for (const char& digit : text) {
      int carry = 0;
      const auto [end, error] = std::from_chars(&digit, &digit + 1, carry, base);
      if (error != std::errc{} || end != &digit + 1) return false;
      for (Bit& bit : code) {
        carry += bit == yes ? base : 0;
        bit = nets::constant(carry % 2 != 0);
        carry /= 2;
      }
      if (carry != 0) return false;
    }
    const auto first = std::ranges::find(code, yes);
    if (!is_minus || first == code.end()) return !text.empty();
    std::for_each(first + 1, code.end(), [](Bit& bit) { bit = !bit; });
    return code.back() == yes;
  }

  static constexpr int kMostLines = 2'000'000'000;

  const std::string& file_;
  Btor2 model_;
  std::vector<std::string> words_;  // of this line
  std::size_t line_ = 0, at_ = 0;
  std::set<int> ids_;
  std::unordered_map<int, int> sorts_;  // widths
  std::unordered_map<int, std::uint32_t> nodes_;
  std::set<std::pair<std::string, std::string>> names_;
  std::vector<std::optional<std::uint32_t>> next_;
  std::vector<std::size_t> state_lines_;
};

}  // namespace

Btor2 read_btor2(std::string_view text, const std::string& file) {
  return Btor2Reader(file).read(text);
}

}  // namespace cosim::nets
