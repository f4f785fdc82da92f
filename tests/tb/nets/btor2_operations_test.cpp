// Golden models as BTOR2: the gates give what integers without a bound give.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "tb/nets/btor2.h"
#include "tb/nets/runs.h"
#include "tb/util/random.h"
#include "tests/clocked/big.h"

namespace cosim::nets {
namespace {

using clocked::test::Big;
using Codes = std::vector<Big>;  // what a word is in each run

bool bit_of(const Big& code, int i) {
  return (code.digit(static_cast<std::size_t>(i / 16)) >> i % 16 & 1) != 0;
}
std::string digits_of(const Big& code, int width, int bits_each) {
  std::string digits;
  for (int i = (width - 1) / bits_each; i >= 0; --i) {
    std::size_t digit = 0;
    for (int k = bits_each; k-- > 0;) digit = 2 * digit + bit_of(code, bits_each * i + k);
    digits += "0123456789abcdef"[digit];
  }
  return digits;
}

int drawn_below(Random& random, int n) {
  return static_cast<int>(random.below(static_cast<std::uint64_t>(n)));
}
// A number of so many bits, often a short one, 0, ones or a single bit.
Big drawn(Random& random, int width) {
  if (random.below(2) == 0) width = 1 + drawn_below(random, width);
  Big code(0);
  const bool is_corner = random.below(2) == 0;
  for (int left = width; left > 0; left -= 32) {
    const int n = std::min(left, 32);
    const Word piece =
        is_corner ? random.corner(n) : cosim::low_bits(static_cast<Word>(random.next()), n);
    code = code * Big::power(n) + Big(piece);
  }
  return code;
}

// An operation on words of one width.
struct Operation {
  const char* name;
  int operands;
  bool is_comparison;
  std::function<Big(const Big& a, const Big& b, int width)> of;
};
Big all_ones(int width) { return Big::power(width) - Big(1); }
int shift_amount(const Big& n, int width) {
  return n < Big(width) ? static_cast<int>(n.digit(0)) : width;
}
bool is_less(const Big& a, const Big& b, int width) {
  return a.with_sign(width) < b.with_sign(width);
}

#define OF(NAME, OPERANDS, IS_COMPARISON, RESULT)                                        \
  Operation {                                                                            \
    NAME, OPERANDS, IS_COMPARISON,                                                       \
        [](const Big& a, [[maybe_unused]] const Big& b, [[maybe_unused]] int w) -> Big { \
          return RESULT;                                                                 \
        }                                                                                \
  }
const std::vector<Operation>& operations_of_one_width() {
  static const std::vector<Operation> all{
      OF("not", 1, false, all_ones(w) - a),
      OF("add", 2, false, (a + b).low(w)),
      OF("sub", 2, false, (a - b).low(w)),
      OF("mul", 2, false, (a * b).low(w)),
      OF("udiv", 2, false, b == Big(0) ? all_ones(w) : a / b),
      OF("urem", 2, false, b == Big(0) ? a : a % b),
      OF("sdiv", 2, false,
         b == Big(0) ? Big(a < Big::power(w - 1) ? -1 : 1).low(w)
                     : (a.with_sign(w) / b.with_sign(w)).low(w)),
      OF("srem", 2, false, b == Big(0) ? a : (a.with_sign(w) % b.with_sign(w)).low(w)),
      OF("and", 2, false, a & b),
      OF("or", 2, false, a | b),
      OF("xor", 2, false, a ^ b),
      OF("sll", 2, false, (a << shift_amount(b, w)).low(w)),
      OF("srl", 2, false, a >> shift_amount(b, w)),
      OF("sra", 2, false, (a.with_sign(w) >> shift_amount(b, w)).low(w)),
      OF("eq", 2, true, a == b),
      OF("neq", 2, true, !(a == b)),
      OF("ult", 2, true, a < b),
      OF("ulte", 2, true, !(b < a)),
      OF("ugt", 2, true, b < a),
      OF("ugte", 2, true, !(a < b)),
      OF("slt", 2, true, is_less(a, b, w)),
      OF("slte", 2, true, !is_less(b, a, w)),
      OF("sgt", 2, true, is_less(b, a, w)),
      OF("sgte", 2, true, !is_less(a, b, w)),
  };
  return all;
}
#undef OF

// A file as it is written, and what its words are in each run.
class Written {
 public:
  explicit Written(std::size_t runs) : runs_(runs) {}

  struct Word {
    int line;  // or minus it, of the inverse
    int width;
    Codes codes;
  };
  int sort(int width) {
    int& at = sorts_[width];
    if (at == 0) at = line(fmt::format("sort bitvec {}", width));
    return at;
  }
  Word input(int width, Codes codes) {
    inputs_.push_back(codes);
    const int of = sort(width);
    return {line(fmt::format("input {} i{}", of, inputs_.size())), width, std::move(codes)};
  }
  Word constant(int width, const Big& code) {
    static const std::pair<const char*, int> kinds[] = {{"const", 1}, {"consth", 4}};
    const auto& [kind, bits_each] = kinds[static_cast<std::size_t>(last_ % 2)];
    return node(kind, width, digits_of(code, width, bits_each), [&](std::size_t) { return code; });
  }
  // OPERANDS is the text behind the sort.
  template <class Of>
  Word node(std::string_view kind, int width, const std::string& operands, Of code) {
    const int of = sort(width);
    Word made{line(fmt::format("{} {} {}", kind, of, operands)), width, {}};
    for (std::size_t run = 0; run < runs_; ++run) made.codes.push_back(code(run));
    return made;
  }
  static Word inverse(Word word) {
    word.line = -word.line;
    for (Big& code : word.codes) code = all_ones(word.width) - code;
    return word;
  }
  Word operation(const Operation& o, const Word& a, const Word& b) {
    const std::string operands =
        o.operands == 1 ? std::to_string(a.line) : fmt::format("{} {}", a.line, b.line);
    return node(o.name, o.is_comparison ? 1 : a.width, operands,
                [&](std::size_t run) { return o.of(a.codes[run], b.codes[run], a.width); });
  }
  void output(const Word& word, const std::string& what) {
    line(fmt::format("output {} o{}", word.line, outputs_.size()));
    outputs_.emplace_back(word, what);
  }

  // Whether the gates give the codes of all outputs.
  void expect_same() const {
    const Btor2 model = read_btor2(text_, "x.btor2");
    ASSERT_EQ(model.inputs.size(), inputs_.size());
    ASSERT_EQ(model.outputs.size(), outputs_.size());
    Graph graph;
    std::vector<Bits> words;
    std::vector<std::uint64_t> planes;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      Bits& word = words.emplace_back();
      for (int k = 0; k < model.inputs[i].width; ++k) {
        word.push_back(graph.input());
        planes.push_back(plane(inputs_[i], k));
      }
    }
    const Clocked clocked = placed(graph, model, words, {});
    const auto gates = run(graph, planes);
    const std::uint64_t used = ~std::uint64_t{0} >> (64 - runs_);
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      const auto& [word, what] = outputs_[i];
      ASSERT_EQ(clocked.outputs[i].size(), static_cast<std::size_t>(word.width));
      for (int k = 0; k < word.width; ++k) {
        const Bit bit = clocked.outputs[i][static_cast<std::size_t>(k)];
        ASSERT_EQ(in_runs(gates, bit) & used, plane(word.codes, k))
            << what << " of " << word.width << " bits, bit " << k;
      }
    }
  }

 private:
  int line(const std::string& text) {
    text_ += fmt::format("{} {}\n", ++last_, text);
    return last_;
  }
  static std::uint64_t plane(const Codes& codes, int bit) {
    std::uint64_t runs = 0;
    for (std::size_t i = 0; i < codes.size(); ++i)
      runs |= std::uint64_t{bit_of(codes[i], bit)} << i;
    return runs;
  }

  std::size_t runs_;
  std::string text_;
  int last_ = 0;
  std::map<int, int> sorts_;
  std::vector<Codes> inputs_;
  std::vector<std::pair<Word, std::string>> outputs_;
};

// Words of one width: free ones, widened ones, constants, chosen and joined ones, and inverses.
class Pool {
 public:
  Pool(Written& file, Random& random, int width, std::size_t runs)
      : file_(file), random_(random), width_(width), runs_(runs) {
    for (int i = 0; i < 3; ++i) add(free(width));
    add(file.constant(width, drawn(random, width)));
    add(file.constant(width, all_ones(width)));
    for (int i = 0; i < 2 && width > 1; ++i) {
      const int narrow = 1 + drawn_below(random, width - 1);
      const Written::Word word = free(narrow), other = free(width - narrow);
      const auto extend = [&](const char* kind, auto of) {
        add(file.node(kind, width, fmt::format("{} {}", word.line, width - narrow), of));
      };
      extend("uext", [&](std::size_t run) { return word.codes[run]; });
      extend("sext", [&](std::size_t run) { return word.codes[run].with_sign(narrow).low(width); });
      add(file.node("concat", width, fmt::format("{} {}", word.line, other.line),
                    [&](std::size_t run) {
                      return word.codes[run] * Big::power(width - narrow) + other.codes[run];
                    }));
    }
    const Written::Word wide = free(width + 5);
    add(file.node("slice", width, fmt::format("{} {} 3", wide.line, width + 2),
                  [&](std::size_t run) { return (wide.codes[run] >> 3).low(width); }));
    const Written::Word choice = free(1), yes = any(), no = any();
    add(file.node("ite", width, fmt::format("{} {} {}", choice.line, yes.line, no.line),
                  [&](std::size_t run) {
                    return choice.codes[run] == Big(0) ? no.codes[run] : yes.codes[run];
                  }));
  }
  const Written::Word& any() const { return words_[random_.below(words_.size())]; }
  void add(const Written::Word& word) {
    if (word.width == width_) words_.push_back(word);
    if (word.width == width_) words_.push_back(Written::inverse(word));
    file_.output(word, "a word");
  }

 private:
  Written::Word free(int width) {
    Codes codes;
    for (std::size_t i = 0; i < runs_; ++i) codes.push_back(drawn(random_, width));
    return file_.input(width, codes);
  }

  Written& file_;
  Random& random_;
  int width_;
  std::size_t runs_;
  std::vector<Written::Word> words_;
};

TEST(Btor2Operations, AreThoseOfBigIntegers) {
  for (const int width : {1, 2, 3, 4, 5, 7, 8, 16, 31, 33, 64, 65}) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      Random random = Random::for_case(seed, static_cast<std::uint64_t>(width));
      Written file(64);
      Pool pool(file, random, width, 64);
      for (const Operation& o : operations_of_one_width()) {
        for (int i = 0; i < 4; ++i) file.output(file.operation(o, pool.any(), pool.any()), o.name);
      }
      file.expect_same();
    }
  }
}

// The results are operands again.
TEST(Btor2Operations, InExpressionsAreThoseOfBigIntegers) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random = Random::for_case(seed, 1000);
    Written file(32);
    Pool pool(file, random, 1 + static_cast<int>(seed), 32);
    for (int i = 0; i < 30; ++i) {
      const auto& o = operations_of_one_width()[random.below(operations_of_one_width().size())];
      pool.add(file.operation(o, pool.any(), pool.any()));
    }
    file.expect_same();
  }
}

TEST(Btor2Operations, OfThreeBitsAreThoseOfAllValues) {
  for (int width = 1; width <= 3; ++width) {
    Written file(64);
    Codes a, b;
    for (int run = 0; run < 64; ++run) {
      a.push_back(Big(run).low(width));
      b.push_back((Big(run) >> width).low(width));
    }
    const Written::Word x = file.input(width, a), y = file.input(width, b);
    for (const Operation& o : operations_of_one_width()) {
      file.output(file.operation(o, x, y), o.name);
    }
    file.expect_same();
  }
}

TEST(Btor2Operations, MayHave4096Bits) {
  Random random(1);
  Written file(2);
  const auto word = [&] { return file.input(4096, {drawn(random, 4096), drawn(random, 4096)}); };
  const Written::Word x = word(), y = word(), n = file.input(4096, {Big(5), Big(4095)});
  for (const Operation& o : operations_of_one_width()) {
    const std::string_view name = o.name;
    if (name == "mul" || name.ends_with("div") || name.ends_with("rem")) continue;
    file.output(file.operation(o, x, name.starts_with("s") && name.size() == 3 ? n : y), o.name);
  }
  file.expect_same();
}

}  // namespace
}  // namespace cosim::nets
