#include "tb/equiv/vhdl_run.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/scratch.h"
#include "tb/util/words.h"

namespace cosim::equiv {
namespace {

// A testbench of VHDL around an entity, which reads rows of inputs and writes rows of outputs.
using VhdlLines = std::vector<std::string>;

/// Each port has lines of its own, so that a line that GHDL complains of tells which port it is.
struct VhdlTestbench {
  std::string text;
  std::map<std::size_t, std::string> port_of;  ///< by line
  std::string error;                           ///< why there is none

  void line(const std::string& one, const std::string& port = "");
};

/// The package that the testbench uses: between the types of ports and the digits of a row. GHDL
/// chooses the function by the type, so that nothing here reads types.
extern const char* const vhdl_conversions;

// Between the types of ports and the digits of a row: GHDL chooses the function by the type.
const char* const vhdl_conversions = R"vhdl(library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
package cosim_ports is
  function bits (x : std_ulogic; w : natural) return string;
  function bits (x : std_ulogic_vector; w : natural) return string;
  function bits (x : unsigned; w : natural) return string;
  function bits (x : signed; w : natural) return string;
  function bits (x : bit; w : natural) return string;
  function bits (x : bit_vector; w : natural) return string;
  function bits (x : boolean; w : natural) return string;
  function bits (x : integer; w : natural) return string;
  function value (s : string; low, high : std_ulogic) return std_ulogic;
  function value (s : string; low, high : integer) return std_ulogic_vector;
  function value (s : string; low, high : integer) return unsigned;
  function value (s : string; low, high : integer) return signed;
  function value (s : string; low, high : bit) return bit;
  function value (s : string; low, high : integer) return bit_vector;
  function value (s : string; low, high : boolean) return boolean;
  function value (s : string; low, high : integer) return integer;
end package;
package body cosim_ports is
  function bits (x : std_ulogic_vector; w : natural) return string is
    constant digits : string(1 to 3) := "01x";
    variable s : string(1 to x'length);
    variable i : positive := 1;
  begin
    for k in x'range loop
      case to_x01(x(k)) is
        when '0' => s(i) := '0';
        when '1' => s(i) := '1';
        when others => s(i) := 'x';
      end case;
      i := i + 1;
    end loop;
    return s;
  end;
  function bits (x : std_ulogic; w : natural) return string is begin return bits(std_ulogic_vector'(0 => x), w); end;
  function bits (x : unsigned; w : natural) return string is begin return bits(std_ulogic_vector(x), w); end;
  function bits (x : signed; w : natural) return string is begin return bits(std_ulogic_vector(x), w); end;
  function bits (x : bit; w : natural) return string is begin return bits(to_stdulogic(x), w); end;
  function bits (x : bit_vector; w : natural) return string is begin return bits(to_stdulogicvector(x), w); end;
  function bits (x : boolean; w : natural) return string is begin if x then return "1"; else return "0"; end if; end;
  function bits (x : integer; w : natural) return string is
    variable s : string(1 to w);
    variable v : integer := x;
  begin
    for i in w downto 1 loop
      if v mod 2 = 1 then s(i) := '1'; else s(i) := '0'; end if;
      v := (v - v mod 2) / 2;
    end loop;
    return s;
  end;
  function value (s : string; low, high : integer) return std_ulogic_vector is
    variable x : std_ulogic_vector(s'length - 1 downto 0);
  begin
    for i in x'range loop
      case s(s'right - i) is
        when '0' => x(i) := '0';
        when '1' => x(i) := '1';
        when others => x(i) := 'X';
      end case;
    end loop;
    return x;
  end;
  function value (s : string; low, high : std_ulogic) return std_ulogic is
    constant x : std_ulogic_vector(0 downto 0) := value(s, 0, 0);
  begin
    return x(0);
  end;
  function value (s : string; low, high : integer) return unsigned is begin return unsigned(std_ulogic_vector'(value(s, low, high))); end;
  function value (s : string; low, high : integer) return signed is begin return signed(std_ulogic_vector'(value(s, low, high))); end;
  function value (s : string; low, high : bit) return bit is begin return to_bit(value(s, '0', '0')); end;
  function value (s : string; low, high : integer) return bit_vector is begin return to_bitvector(std_ulogic_vector'(value(s, low, high))); end;
  function value (s : string; low, high : boolean) return boolean is begin return s = "1"; end;
  function value (s : string; low, high : integer) return integer is
    variable v : integer := 0;
  begin
    if low < 0 and s(s'left) = '1' then v := -1; end if;
    for i in s'range loop
      v := 2 * v;
      if s(i) = '1' then v := v + 1; end if;
    end loop;
    if v < low then return low + (v - low) mod (high - low + 1); end if;
    if v > high then return low + (v - high - 1) mod (high - low + 1); end if;
    return v;
  end;
end package body;
)vhdl";

bool has_falling_edge(const VhdlStimulus& s, const std::string& clock) {
  const auto found = s.falls.find(clock);
  return found != s.falls.end() && found->second;
}

// The declaration of the signal of an input or an output, and what it begins with.
void declare_ports(VhdlTestbench& tb, const VhdlEntity& entity, const VhdlStimulus& s) {
  std::map<std::string, std::string> first;
  std::size_t at = s.clocks.size();
  for (const std::string& clock : s.clocks)
    first[small_letters(clock)] = has_falling_edge(s, clock) ? "'1'" : "'0'";
  for (const auto& [name, width] : s.inputs) {
    const auto bits = s.rows.empty() ? std::string(static_cast<std::size_t>(width), '0')
                                     : s.rows.front().substr(at, static_cast<std::size_t>(width));
    first[small_letters(name)] =
        fmt::format("work.cosim_ports.value(\"{}\", cosim_t'low, cosim_t'high)", bits);
    at += static_cast<std::size_t>(width);
  }
  std::map<std::string, bool> known;
  int number = 0;
  for (const VhdlPort& port : entity.ports) {
    const std::string small = small_letters(port.name);
    known[small] = true;
    const auto begin = first.find(small);
    if (port.mode == "inout" || port.mode == "linkage") {
      tb.error = fmt::format("port {}: GHDL is not given {} ports", port.name, port.mode);
    } else if (port.mode == "in" && begin == first.end()) {
      tb.error = fmt::format("port {}: no value is given", port.name);
    }
    const std::string type = fmt::format("cosim_t{}", number++);
    std::string value = begin == first.end() ? "" : " := " + begin->second;
    for (auto t = value.find("cosim_t'"); t != std::string::npos; t = value.find("cosim_t'"))
      value.replace(t, 7, type);
    tb.line(fmt::format("  subtype {0} is {1}; signal {2} : {0}{3};", type, one_line(port.type),
                        port.name, value),
            port.name);
  }
  for (const auto& [name, value] : first) {
    if (!known.contains(name)) tb.error = fmt::format("port {}: the entity has none", name);
  }
  for (const auto& [name, width] : s.outputs) {
    if (!known.contains(small_letters(name)))
      tb.error = fmt::format("port {}: the entity has none", name);
  }
}

std::string vhdl_type_of(const VhdlEntity& entity, const std::string& name) {
  const auto is_it = [&](const VhdlPort& p) {
    return small_letters(p.name) == small_letters(name);
  };
  return fmt::format("cosim_t{}", std::ranges::find_if(entity.ports, is_it) - entity.ports.begin());
}

// The characters of a row of the stimulus.
std::size_t vhdl_row_length(const VhdlStimulus& s) {
  std::size_t length = s.clocks.size();
  for (const auto& [name, width] : s.inputs) length += static_cast<std::size_t>(width);
  return length;
}

void VhdlTestbench::line(const std::string& one, const std::string& port) {
  text += one + '\n';
  if (!port.empty()) port_of[static_cast<std::size_t>(std::ranges::count(text, '\n'))] = port;
}

// The entity cosim_tb, which reads FOLDER/in and writes FOLDER/out: rows of the stimulus as they
// are run, and behind each the outputs.
VhdlTestbench vhdl_testbench(const VhdlEntity& entity, const VhdlStimulus& s,
                             const std::string& folder) {
  VhdlTestbench tb;
  tb.text = entity.context;
  tb.line("entity cosim_tb is");
  if (!entity.generics.empty()) tb.line(fmt::format("  generic ({});", entity.generics));
  tb.line("end entity;\narchitecture run of cosim_tb is");
  declare_ports(tb, entity, s);
  if (!tb.error.empty()) return tb;
  const auto map = [](const VhdlLines& names) {
    VhdlLines pairs;
    for (const std::string& name : names) pairs.push_back(fmt::format("{0} => {0}", name));
    return fmt::format("map ({})", fmt::join(pairs, ", "));
  };
  VhdlLines ports;
  for (const VhdlPort& port : entity.ports) ports.push_back(port.name);
  tb.line(fmt::format("begin\n  cosim_dut : entity work.{}{}{};", entity.name,
                      entity.generic_names.empty() ? "" : " generic " + map(entity.generic_names),
                      ports.empty() ? "" : " port " + map(ports)));
  tb.line(fmt::format(R"(  process
    file cosim_in : std.textio.text open read_mode is "{0}/in";
    file cosim_out : std.textio.text open write_mode is "{0}/out";
    variable cosim_l, cosim_o : std.textio.line;
    variable cosim_r : string(1 to {1});
  begin
    while not std.textio.endfile(cosim_in) loop
      std.textio.readline(cosim_in, cosim_l);
      std.textio.read(cosim_l, cosim_r);)",
                      folder, vhdl_row_length(s)));
  std::size_t at = s.clocks.size() + 1;
  for (const auto& [name, width] : s.inputs) {
    const std::size_t last = at + static_cast<std::size_t>(width) - 1;
    tb.line(
        fmt::format("      {0} <= work.cosim_ports.value(cosim_r({1} to {2}), {3}'low, {3}'high);",
                    name, at, last, vhdl_type_of(entity, name)),
        name);
    at = last + 1;
  }
  tb.line("      wait for 1 us;");
  tb.line(fmt::format("      std.textio.write(cosim_o, cosim_r(1 to {}));", s.clocks.size()));
  for (const auto* ports_of : {&s.inputs, &s.outputs}) {
    for (const auto& [name, width] : *ports_of) {
      tb.line(fmt::format("      std.textio.write(cosim_o, work.cosim_ports.bits({}, {}));", name,
                          width),
              name);
    }
  }
  tb.line("      std.textio.writeline(cosim_out, cosim_o);");
  for (std::size_t i = 0; i < s.clocks.size(); ++i) {
    tb.line(fmt::format("      if cosim_r({}) = '1' then {} <= '{}'; end if;", i + 1, s.clocks[i],
                        has_falling_edge(s, s.clocks[i]) ? 0 : 1),
            s.clocks[i]);
  }
  tb.line("      wait for 1 us;");
  for (const std::string& clock : s.clocks) {
    tb.line(fmt::format("      {} <= '{}';", clock, has_falling_edge(s, clock) ? 1 : 0), clock);
  }
  tb.line("      wait for 1 us;");
  tb.line("    end loop;\n    std.env.finish;\n  end process;\nend architecture;");
  return tb;
}

// What GHDL says is wrong, with the port where it is a line of the testbench.
std::string vhdl_reason(const std::string& text, const VhdlTestbench& tb) {
  static const Pattern unbound(R"((\S+:\d+):\d+:warning: (.* is not bound).*)"),
      located(R"((\S+:\d+):\d+: ?(?!note|warning)(.*))"), stopped(R"(\S*:error: (.*))"),
      caller(R"(  from: .* at (.*))"), of_testbench(R"(cosim_tb\.vhd:(\d+))");
  std::string said;
  bool is_placed = false;  // in a file, and none of the standard's
  for (const std::string& line : lines_in(text)) {
    Pattern::Parts parts = unbound.whole(line);
    if (parts.empty()) parts = located.whole(line);
    if (parts.empty() && said.empty()) parts = stopped.whole(line);
    if (parts.size() == 3 && said.empty()) said = parts[1] + ": " + parts[2];
    if (parts.size() == 2) said = parts[1];
    is_placed = said.find(" at ") != std::string::npos && said.find("-body.") == std::string::npos;
    parts = caller.whole(line);
    if (said.empty() || is_placed || parts.empty() || parts[1].find("-body.") != std::string::npos)
      continue;
    said += ", from " + parts[1];
    break;
  }
  for (const Pattern::Parts& place : of_testbench.all(said)) {
    const auto port = tb.port_of.find(std::stoul(place[1]));
    if (port == tb.port_of.end()) continue;
    const char* why =
        said.find("bound") != std::string::npos
            ? "its type has no such value, or not so many bits"
            : "its type is not std_logic, bit, boolean, an integer or a vector of these";
    return fmt::format("port {}: {}", port->second, why);
  }
  return said.empty() ? "GHDL ends without a reason" : one_line(said);
}

}  // namespace

VhdlRun run_vhdl(const VhdlLines& files, const std::string& top, const VhdlLines& generics,
                 const VhdlStimulus& stimulus, std::chrono::steady_clock::time_point until) {
  std::optional<VhdlEntity> entity;
  for (const std::string& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    if (!entity) entity = entity_in(text.str(), top);
  }
  if (!entity) return {{}, {}, fmt::format("no file has the entity {}", top)};
  const Scratch scratch;
  const std::string folder = scratch.path().string();
  const VhdlTestbench tb = vhdl_testbench(*entity, stimulus, folder);
  if (!tb.error.empty()) return {{}, {}, tb.error};
  const std::string bench = folder + "/cosim_tb.vhd", ports = folder + "/cosim_ports.vhd";
  std::ofstream(ports) << vhdl_conversions;
  std::ofstream(bench) << tb.text;
  std::ofstream(folder + "/in") << fmt::format("{}\n", fmt::join(stimulus.rows, "\n"));
  const auto ghdl = [&](const char* command, const VhdlLines& words) {
    VhdlLines all{"ghdl", command, "--std=08", "-fsynopsys", "--workdir=" + folder};
    all.insert(all.end(), words.begin(), words.end());
    return run_until(all, until);
  };
  VhdlLines sources = files, options{"cosim_tb", "--ieee-asserts=disable", "--assert-level=none"};
  sources.insert(sources.end(), {ports, bench});
  for (const std::string& generic : generics) options.push_back("-g" + generic);
  static const Pattern unbound("is not bound");
  Ended ended = ghdl("-i", sources);
  if (ended.status == 0) ended = ghdl("-m", {"cosim_tb"});
  const bool is_open = unbound.in(ended.text);
  if (ended.status == 0 && !is_open) ended = ghdl("-r", options);
  if (ended.status == 127) return {{}, {}, "needs ghdl"};
  VhdlRun run;
  std::size_t bits = vhdl_row_length(stimulus), inputs = bits;
  for (const auto& [name, width] : stimulus.outputs) bits += static_cast<std::size_t>(width);
  std::ifstream out(folder + "/out");
  for (std::string row; std::getline(out, row);) {
    if (row.size() != bits) {
      return {{}, {}, fmt::format("the ports have {} bits in VHDL, not {}", row.size(), bits)};
    }
    run.inputs.push_back(row.substr(0, inputs));
    run.rows.push_back(row.substr(inputs));
  }
  if (ended.timed_out) {
    run.error = "no time was left for GHDL";
  } else if (ended.status != 0 || is_open) {
    run.error = vhdl_reason(ended.text, tb);
  } else if (run.rows.size() < stimulus.rows.size()) {
    run.error = "the VHDL ends its simulation";
  }
  return run;
}

}  // namespace cosim::equiv
