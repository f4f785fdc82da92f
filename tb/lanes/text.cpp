// What is compiled.
#include <fmt/core.h>

#include "tb/lanes/code.h"
#include "tb/sim/hostile.h"

namespace cosim::lanes {
namespace {

// T(table, a, b, c) is one plain instruction, or one of three inputs where the processor has it;
// else the fewest plain ones, found by trying each input as the one that chooses between two
// functions of the others.
constexpr const char* prelude = R"(#include <cstdint>
#include <cstring>

#if COSIM_LANES > 64
typedef std::uint64_t V __attribute__((vector_size(COSIM_LANES / 8)));
#else
typedef std::uint64_t V;
#endif
#if COSIM_LANES == 512 && defined(__AVX512F__)
#include <immintrin.h>
constexpr int most_plain = 1;
template <int table>
static inline V three(V a, V b, V c) {
  return (V)_mm512_ternarylogic_epi64((__m512i)c, (__m512i)b, (__m512i)a, table);
}
#else
constexpr int most_plain = 100;
template <int>
static inline V three(V, V, V);
#endif
// Of two inputs, bit 2 b + a of the table.
template <int table>
static inline V two(V a, V b) {
  if constexpr (table == 0) return a ^ a;
  else if constexpr (table == 1) return ~(a | b);
  else if constexpr (table == 2) return a & ~b;
  else if constexpr (table == 3) return ~b;
  else if constexpr (table == 4) return b & ~a;
  else if constexpr (table == 5) return ~a;
  else if constexpr (table == 6) return a ^ b;
  else if constexpr (table == 7) return ~(a & b);
  else if constexpr (table == 8) return a & b;
  else if constexpr (table == 9) return ~(a ^ b);
  else if constexpr (table == 10) return a;
  else if constexpr (table == 11) return a | ~b;
  else if constexpr (table == 12) return b;
  else if constexpr (table == 13) return b | ~a;
  else if constexpr (table == 14) return a | b;
  else return ~(a ^ a);
}
constexpr int cost_of_two(int t) {
  return t == 0 || t == 15 || t == 10 || t == 12 ? 0 : t == 1 || t == 7 || t == 9 ? 2 : 1;
}
constexpr int cost(int no, int yes) {
  if (no == yes) return cost_of_two(no);
  if (no == (yes ^ 15) || no == 0 || no == 15 || yes == 0 || yes == 15) {
    return 1 + (no == 0 || no == 15 ? cost_of_two(yes) : cost_of_two(no));
  }
  return 3 + cost_of_two(no) + cost_of_two(yes);
}
template <int no, int yes>
static inline V choose(V c, V a, V b) {
  if constexpr (no == yes) return two<no>(a, b);
  else if constexpr (no == (yes ^ 15)) return c ^ two<no>(a, b);
  else if constexpr (no == 0) return c & two<yes>(a, b);
  else if constexpr (yes == 0) return ~c & two<no>(a, b);
  else if constexpr (yes == 15) return c | two<no>(a, b);
  else if constexpr (no == 15) return ~c | two<yes>(a, b);
  else {
    const V l = two<no>(a, b);
    return l ^ (c & (l ^ two<yes>(a, b)));
  }
}
#define M(i) m[i]
#define T(t, ...) cell<t>(__VA_ARGS__)
template <int t>
static inline V cell(V a, V b, V c) {
  constexpr int b_no = (t & 3) | (t >> 2 & 12), b_yes = (t >> 2 & 3) | (t >> 4 & 12);
  constexpr int a_no = (t & 1) | (t >> 1 & 2) | (t >> 2 & 4) | (t >> 3 & 8);
  constexpr int a_yes = (t >> 1 & 1) | (t >> 2 & 2) | (t >> 3 & 4) | (t >> 4 & 8);
  constexpr int by_c = cost(t & 15, t >> 4), by_b = cost(b_no, b_yes), by_a = cost(a_no, a_yes);
  if constexpr (by_a > most_plain && by_b > most_plain && by_c > most_plain) return three<t>(a, b, c);
  else if constexpr (by_c <= by_b && by_c <= by_a) return choose<t & 15, (t >> 4)>(c, a, b);
  else if constexpr (by_b <= by_a) return choose<b_no, b_yes>(b, a, c);
  else return choose<a_no, a_yes>(a, b, c);
}
static inline std::uint64_t count(V v) {
  std::uint64_t words[sizeof(V) / 8], sum = 0;
  std::memcpy(words, &v, sizeof v);
  for (const std::uint64_t w : words) sum += static_cast<std::uint64_t>(__builtin_popcountll(w));
  return sum;
}
static inline bool any(V v) {
  std::uint64_t words[sizeof(V) / 8], all = 0;
  std::memcpy(words, &v, sizeof v);
  for (const std::uint64_t w : words) all |= w;
  return all != 0;
}
static const V Z = V{}, O = ~V{};
// What is loaded behind it is loaded there: the compiler does not hold it in a register from before.
#define FORGET asm volatile("" : "+m"(t) : : "memory")
)";

// Of the registers that a value fits into, less what a cell needs beside its inputs.
std::size_t registers(int lanes) { return lanes == 512 ? 30 : lanes == 256 ? 13 : 11; }

std::string function(const char* name, const Straight& body, int lanes) {
  return fmt::format(
      "__attribute__((noinline)) static V {}(V* const m, [[maybe_unused]] const V active,\n"
      "    [[maybe_unused]] std::uint64_t* const left_out) {{\n  V differ = V{{}};\n{}  return "
      "differ & active;\n}}\n",
      name, body.text(registers(lanes)));
}

}  // namespace

std::string to_text(const Code& code, int lanes) {
  std::string functions =
      function("stretch", code.stretch, lanes) + function("reset", code.reset, lanes) +
      function("take_over", code.take_over, lanes) + function("clock", code.clock, lanes);
  if (code.has_quiet) {
    functions += function("loud", code.loud, lanes) + function("quiet", code.quiet, lanes);
  }
  return fmt::format("#define COSIM_LANES {}\n{}{}", lanes, prelude, functions) +
         fmt::format(R"(extern "C" {{
extern const int cosim_lanes;
extern const char cosim_lanes_layout[];
const int cosim_lanes = COSIM_LANES;
const char cosim_lanes_layout[] = "{}";
}}
extern "C" void cosim_lanes_reset(V* m) {{
  for (int i = 0; i < {}; ++i) reset(m, V{{}}, nullptr);
}}
extern "C" void cosim_lanes_take_over(V* m) {{ take_over(m, V{{}}, nullptr); }}
extern "C" void cosim_lanes_choose(V* m, const V* which, const V* from, std::uint64_t planes) {{
  for (std::uint64_t i = 0; i < planes; ++i) m[i] = m[i] ^ (*which & (m[i] ^ from[i]));
}}
extern "C" void cosim_lanes_clear(V* m, const V* which, std::uint64_t planes) {{
  for (std::uint64_t i = 0; i < planes; ++i) m[i] &= ~*which;
}}
extern "C" std::int64_t cosim_lanes_run(V* m, const V* active, std::uint64_t from, std::uint64_t to,
                                        V* differ, std::uint64_t* left_out) {{
  for (std::uint64_t at = from; at < to; ++at) {{
    if (at % {} == 0) stretch(m, *active, left_out);
    const V d = {};
    if (any({})) {{
      *differ = d;
      return static_cast<std::int64_t>(at);
    }}
  }}
  return -1;
}}
)",
                     to_text(code.layout), code.reset_clocks, HostileCase::stretch,
                     code.has_quiet ? "(any(loud(m, *active, left_out)) ? clock : quiet)(m, "
                                      "*active, left_out)"
                                    : "clock(m, *active, left_out)",
                     code.is_asked ? "d | (m[0] & *active)" : "d");
}

}  // namespace cosim::lanes
