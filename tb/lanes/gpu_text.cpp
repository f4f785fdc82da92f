// The source of the kernels. Each plane that a clock reads or writes is a variable of its own, for
// an array stays in memory; those for which registers do not suffice are in local memory, first the
// ones that a clock reads only, which are not written back. All other planes stay in the memory of
// the device.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "tb/lanes/gpu.h"
#include "tb/sim/hostile.h"

namespace cosim::lanes {
namespace {

// Of a clock's own values; more are planes of their own.
constexpr std::size_t gpu_registers = 200;

// The two functions of a and b between which c chooses: the compiler leaves out what is constant.
std::string cell_functions() {
  constexpr std::array two{"Z",     "~(a | b)", "a & ~b", "~b",       "b & ~a", "~a",
                           "a ^ b", "~(a & b)", "a & b",  "~(a ^ b)", "a",      "a | ~b",
                           "b",     "b | ~a",   "a | b",  "O"};
  std::string plain = "#ifdef LOP3\n", all;
  for (std::size_t t = 0; t < 256; ++t) {
    plain += fmt::format(
        "inline V T_0x{0:02x}(V a, V b, V c) {{ V d; asm(\"lop3.b32 %0, %1, %2, %3, {0};\" : "
        "\"=r\"(d) : \"r\"(c), \"r\"(b), \"r\"(a)); return d; }}\n",
        t);
    all +=
        fmt::format("inline V T_0x{:02x}(V a, V b, V c) {{ return ((({}) ^ ({})) & c) ^ ({}); }}\n",
                    t, two.at(t & 15), two.at(t >> 4), two.at(t & 15));
  }
  return plain + "#else\n" + all + "#endif\n";
}

// The planes that stand in a text, and whether it writes them.
std::map<std::size_t, bool> planes_of(const std::string& text) {
  std::map<std::size_t, bool> planes;
  for (std::size_t at = text.find("M("); at != std::string::npos; at = text.find("M(", at + 1)) {
    const std::size_t end = text.find(')', at);
    planes[std::stoul(text.substr(at + 2, end - at - 2))] |= text.compare(end, 4, ") = ") == 0;
  }
  return planes;
}

std::string begun(const Code& code) {
  const auto& planes = code.layout.planes;
  const auto seeds = static_cast<std::size_t>(std::ranges::count(planes, Layout::First::seed));
  std::string text = fmt::format(R"(#define M(i) g[i##u * S + thread]
ulong mixed(ulong z) {{
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ul;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebul;
  return z ^ (z >> 31);
}}
kernel void begin(global V* g, uint S, ulong seed, ulong first) {{
  const uint thread = get_global_id(0);
  const ulong step = 0x9e3779b97f4a7c15ul;
  for (uint i = 0; i < {}; ++i) {{
    V planes[64];
    for (int b = 0; b < 64; ++b) planes[b] = Z;
    for (uint lane = 0; lane < 32; ++lane) {{
      const ulong number = first + 32 * (ulong)thread + lane;
      const ulong state = mixed((seed ^ (number * step + 0x632be59bd9b4e019ul)) + step);
      ulong word = mixed(state + (i + 1) * step);
      if (word == 0) word = 1;
      for (int b = 0; b < 64; ++b) planes[b] |= (V)(word >> b & 1) << lane;
    }}
    for (uint b = 0; b < 64; ++b) g[(64 * i + b) * S + thread] = planes[b];
  }}
)",
                                 seeds / 64);
  for (std::size_t i = seeds; i < planes.size(); ++i) {
    const std::string from = planes[i] == Layout::First::yes  ? "O"
                             : planes[i] == Layout::First::no ? "Z"
                                                              : fmt::format("M({})", i % seeds);
    text += fmt::format("  M({}) = {};\n", i, from);
  }
  text += fmt::format("  for (int i = 0; i < {}; ++i) {{\n  V differ = Z;\n{}  }}\n",
                      code.reset_clocks, code.reset.text(gpu_registers));
  return text + "  {\n  V differ = Z;\n" + code.take_over.text(gpu_registers) +
         "  }\n}\n#undef M\n";
}

std::string ran(const Code& code) {
  Straight merging = code.clock;
  const std::vector<Straight::Merged> merged = merging.merge(code.layout.state);
  const std::string clock = merging.text(gpu_registers), stretch = code.stretch.text(gpu_registers);
  const auto used = planes_of(clock);
  std::vector<std::pair<std::size_t, bool>> order(used.begin(), used.end());
  std::ranges::stable_sort(order, {}, [](const auto& p) { return p.second; });
  std::size_t cells = 0;
  for (std::size_t at = clock.find(" T("); at != std::string::npos;
       at = clock.find(" T(", at + 1)) {
    ++cells;
  }
  std::string text =
      fmt::format("// cells {}\n// planes {}\n#define M(i) M_##i\n", cells, order.size());
  std::string loaded, stored;
  std::size_t place = 0;
  for (const auto& [plane, is_written] : order) {
    text += fmt::format(
        "#if {0} < COSIM_LOCAL\n#define M_{1} s[{0} * {2} + own]\n#define D_{1}\n#else\n"
        "#define M_{1} m{1}\n#define D_{1} V m{1};\n#endif\n",
        place++, plane, Gpu::group);
    loaded += fmt::format("  D_{0} M_{0} = g[{0}u * S + thread];\n", plane);
    if (is_written) stored += fmt::format("  g[{0}u * S + thread] = M_{0};\n", plane);
  }
  for (const auto& [plane, is_written] : planes_of(stretch)) {
    if (used.count(plane) != 0) {
      if (is_written && !used.at(plane)) {
        stored += fmt::format("  g[{0}u * S + thread] = M_{0};\n", plane);
      }
    } else {
      text += fmt::format("#define M_{0} g[{0}u * S + thread]\n", plane);
    }
  }
  // A difference of the last clock goes on in the first pair.
  for (const auto& [kept, dropped] : merged) {
    loaded += fmt::format("  late |= M_{} ^ g[{}u * S + thread];\n", kept, dropped);
    stored += fmt::format("  g[{}u * S + thread] = M_{} ^ late;\n", dropped, kept);
  }
  text += fmt::format(
      R"(kernel __attribute__((reqd_work_group_size({0}, 1, 1))) void run(global V* g, uint S, uint from,
    uint to, ulong count, global uint* found, global uint* left) {{
  const uint thread = get_global_id(0), own = get_local_id(0);
#if COSIM_LOCAL
  local volatile V s[COSIM_LOCAL * {0}];
#endif
  V late = Z;
{1}  uint left_out[{2}], is = O;
  for (int i = 0; i < {2}; ++i) left_out[i] = 0;
  const ulong before = 32 * (ulong)thread;
  V active = count >= before + 32 ? O : count <= before ? Z : (1u << (uint)(count - before)) - 1;
  for (uint at = from; at < to;) {{
    if (at % {3} == 0) {{
  V differ = Z;
{4}    }}
    const uint end = min(to, (at / {3} + 1) * {3});
    for (; at < end; ++at) {{
  V differ = late;
  late = Z;
{5}  differ &= active;
      if (differ != 0) {{
        const V below = (differ & -differ) - 1;
        active &= below;
        is = at << 5 | popcount(below);
      }}
    }}
  }}
{6}  found[thread] = is;
)",
      Gpu::group, loaded, std::max<std::size_t>(code.layout.counters, 1), HostileCase::stretch,
      stretch, clock, stored);
  if (code.layout.counters != 0) {
    text += fmt::format("  for (uint i = 0; i < {}; ++i) left[i * S + thread] = left_out[i];\n",
                        code.layout.counters);
  }
  return text + "}\n";
}

}  // namespace

std::string to_opencl(const Code& code) {
  return "// " + to_text(code.layout) +
         "\ntypedef uint V;\n#define Z 0u\n#define O 0xffffffffu\n#define FORGET\n"
         "#define count(v) popcount(v)\n#define T(t, a, b, c) T_##t(a, b, c)\n" +
         cell_functions() + begun(code) + ran(code);
}

}  // namespace cosim::lanes
