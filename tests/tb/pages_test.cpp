// What stands as C++ in the pages of docs/ and in no example: compiled here, and tried.
#include <gtest/gtest.h>

#include <cosim/stream.h>

#include "tb/sim/directed.h"

namespace cosim {
namespace {

struct Pwm {
  struct In {
    Bit rst;
    UInt<4> level;
  };
  struct Out {
    Bit out;
  };
  UInt<4> count = 0, duty = 0;

  Out clock(const In& in) {
    const Out out{.out = count < duty};
    if (in.rst) {
      *this = Pwm{};
    } else {
      if (reduce_and(count)) duty = in.level;
      ++count;
    }
    return out;
  }
};

TEST(Pages, APulseIsAsWideAsItsLevel) {
  Pwm pwm;
  int high = 0;
  for (int i = 0; i < 16; ++i) pwm.clock({.rst = 0, .level = 5});
  for (int i = 0; i < 16; ++i) high += int(pwm.clock({.rst = 0, .level = 5}).out);
  EXPECT_EQ(high, 5);
}

struct Triple {
  struct XData {
    UInt<8> data;
  };
  struct YData {
    UInt<10> data;
  };
  static std::vector<YData> run(const std::vector<XData>& x) {
    std::vector<YData> y;
    for (const XData& one : x) y.push_back({3 * one.data});
    return y;
  }
};

TEST(Pages, EachIsTripled) {
  const auto y = Triple::run({{255}, {2}});
  ASSERT_EQ(y.size(), 2U);
  EXPECT_EQ(int(y[0].data), 765);
  EXPECT_EQ(int(y[1].data), 6);
}

struct Memory {
  enum class Kind { read, write };
  struct X {
    Enum<Kind> kind;
    UInt<6> address;
  };
  static auto draws() {
    return std::tuple{drawn(&X::address, {0, 4, {8, 63, 3}, any(1)}),
                      drawn(&X::kind, {Kind::read, {Kind::write, 4}})};
  }
  static X arranged(X x) {
    if (x.kind == Kind::write) x.address = x.address & 0x3c;
    return x;
  }
  // clang-format off
  static auto cases(const X& x) {
    return std::tuple{stated({{"the last word", x.address == 63}}),
                      crossed(values(x.kind), stated({{"low", x.address < 32}, {"high", x.address >= 32}}))};
  }
  // clang-format on
  static std::string text_of(const X& x);
  static std::string state_after(const std::vector<X>& x);  // the arguments of run()
};
std::string Memory::text_of(const X& x) { return x.kind == Kind::write ? "write" : "read"; }
std::string Memory::state_after(const std::vector<X>& x) { return std::to_string(x.size()); }

TEST(Pages, RulesOfTransactions) {
  const Memory::X drawn{.kind = Memory::Kind::write, .address = 63};
  EXPECT_EQ(int(Memory::arranged(drawn).address), 60);
  EXPECT_EQ(Memory::text_of(drawn) + Memory::state_after({drawn}), "write1");
  EXPECT_EQ(std::tuple_size_v<decltype(Memory::draws())>, 2U);
  EXPECT_EQ(std::tuple_size_v<decltype(Memory::cases(drawn))>, 2U);
}

// Compiled alone: no RTL of it is here.
template <int W>
struct Counter {
  struct In {
    Bit rst, en;
  };
  struct Out {
    UInt<W> count;
  };
  static constexpr auto reset = active_high<&In::rst>;
  static constexpr std::array unobserved{"debug.*", "count[7:4]"};
  UInt<W> total = 0;
  Out clock(const In& in) {
    const Out out{.count = total};
    total = in.rst ? UInt<W>(0) : UInt<W>(total + in.en);
    return out;
  }
};
#pragma push_macro("TEST")  // those of the files behind this one in a unity build are run
#undef TEST
#define TEST(suite, name) [[maybe_unused]] void suite##name()
TEST(Counter, Counts) {
  cosim::Directed<Counter<4>> bench;  // the struct at its configuration
  bench.in.en = 1;                    // pins keep their values
  bench.clocks(5);
  EXPECT_EQ(bench.clock().count, 5);
}
#pragma pop_macro("TEST")

}  // namespace
}  // namespace cosim
