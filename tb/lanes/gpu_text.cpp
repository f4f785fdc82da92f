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
#include "tb/util/pattern.h"

namespace cosim::lanes {
namespace {

// A thread has 255 registers: for a clock's own values, more of which are planes, and for planes.
constexpr std::size_t gpu_registers = 200, planes_in_registers = 96;

// The two functions of a and b between which c chooses: the compiler leaves out what is constant.
std::string cell_functions(bool has_lop3) {
  constexpr std::array two{"Z",     "~(a | b)", "a & ~b", "~b",       "b & ~a", "~a",
                           "a ^ b", "~(a & b)", "a & b",  "~(a ^ b)", "a",      "a | ~b",
                           "b",     "b | ~a",   "a | b",  "O"};
  constexpr auto plain = "return ((({0}) ^ ({1})) & c) ^ ({0});";
  constexpr auto lop3 =
      R"(V d; asm("lop3.b32 %0, %1, %2, %3, {};" : "=r"(d) : "r"(c), "r"(b), "r"(a)); return d;)";
  std::string text;
  for (std::size_t t = 0; t < 256; ++t) {
    const auto body =
        has_lop3 ? fmt::format(lop3, t) : fmt::format(plain, two[t & 15], two[t >> 4]);
    text += fmt::format("inline V T_0x{:02x}(V a, V b, V c) {{ {} }}\n", t, body);
  }
  return text;
}

// The planes that stand in a text, and whether it writes them.
std::map<std::size_t, bool> planes_of(const std::string& text) {
  static const Pattern use(R"(M\((\d+)\)( = )?)");
  std::map<std::size_t, bool> planes;
  for (const auto& parts : use.all(text)) planes[std::stoul(parts[1])] |= !parts[2].empty();
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

}  // namespace

std::string to_opencl(const Code& code, const Device& device) {
  Straight merging = code.clock;
  const std::vector<Straight::Merged> merged = merging.merge(code.layout.state);
  const std::string clock = merging.text(gpu_registers), stretch = code.stretch.text(gpu_registers);
  const auto used = planes_of(clock);
  std::vector<std::pair<std::size_t, bool>> order(used.begin(), used.end());
  std::ranges::stable_sort(order, {}, [](const auto& p) { return p.second; });
  // Registers first, then local memory, as far as it goes.
  const std::size_t fit = device.local_bytes / (4 * Device::group);
  const std::size_t local =
      std::min(order.size() - std::min(order.size(), planes_in_registers), fit - fit / 32);
  std::string text, loaded, stored;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t plane = order[i].first;
    text += i < local ? fmt::format("#define M_{} s[{} * {} + own]\n", plane, i, Device::group)
                      : fmt::format("#define M_{0} m{0}\n", plane);
    loaded += fmt::format("  {0}M_{1} = g[{1}u * S + thread];\n", i < local ? "" : "V ", plane);
  }
  for (const auto& [plane, is_written] : planes_of(clock + stretch)) {
    const bool is_loaded = used.count(plane) != 0;
    if (!is_loaded) text += fmt::format("#define M_{0} g[{0}u * S + thread]\n", plane);
    if (is_loaded && is_written) stored += fmt::format("  g[{0}u * S + thread] = M_{0};\n", plane);
  }
  // A difference of the last clock goes on in the first pair.
  for (const auto& [kept, dropped] : merged) {
    loaded += fmt::format("  late |= M_{} ^ g[{}u * S + thread];\n", kept, dropped);
    stored += fmt::format("  g[{}u * S + thread] = M_{} ^ late;\n", dropped, kept);
  }
  return fmt::format("// {} {} {} {}\n", Pattern(R"( T\()").all(clock).size(), order.size(), local,
                     to_text(code.layout)) +
         "typedef uint V;\n#define Z 0u\n#define O 0xffffffffu\n#define FORGET\n"
         "#define count(v) popcount(v)\n#define T(t, a, b, c) T_##t(a, b, c)\n" +
         cell_functions(device.is_nvidia) + begun(code) + "#define M(i) M_##i\n" + text +
         fmt::format(
             R"(kernel __attribute__((reqd_work_group_size({0}, 1, 1))) void run(global V* g, uint S,
    uint from, uint to, ulong count, global uint* found, global uint* left) {{
  const uint thread = get_global_id(0), own = get_local_id(0);
  local volatile V s[{7} * {0}];
  V late = Z;
{1}  uint left_out[{2}] = {{0}}, is = O;
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
  for (uint i = 0; i < {2}; ++i) left[i * S + thread] = left_out[i];
}}
)",
             Device::group, loaded, std::max<std::size_t>(code.layout.counters, 1),
             HostileCase::stretch, stretch, clock, stored, std::max<std::size_t>(local, 1));
}

}  // namespace cosim::lanes
