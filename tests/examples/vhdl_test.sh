#!/usr/bin/env bash
# vhdl_test.sh PROGRAM
#
# `cosim new` reads VHDL: packages, entities in any order of files, generics, registers by the names
# of their signals; VHDL below Verilog; and what GHDL says of VHDL that it does not read is one line.
# Status: 0 so, 1 not, 77 where ghdl is not installed.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"
needs ghdl

mkdir rtl
cat > rtl/a_top.vhd << 'RTL'
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.Kinds.all;
entity Top is  -- an entity work.none port map (in a comment)
  generic (WIDTH : positive := 8; KIND : string := "any");
  port (CLK, RST_N : in std_logic; D : in std_logic_vector(WIDTH-1 downto 0);
        Q : out std_logic_vector(WIDTH-1 downto 0));
end entity;
architecture rtl of top is
  signal Sum : unsigned(WIDTH-1 downto 0);
  signal phase : phase_t;
  signal held : std_logic_vector(WIDTH-1 downto 0);
begin
  below : entity work.STORE generic map (N => WIDTH) port map (clk => CLK, d => D, q => held);
  process (CLK, RST_N) begin
    if RST_N = '0' then
      Sum <= (others => '0');
      phase <= first;
    elsif rising_edge(CLK) then
      Sum <= Sum + unsigned(held);
      case phase is
        when first => phase <= second;
        when second => phase <= third;
        when third => phase <= first;
      end case;
    end if;
  end process;
  Q <= std_logic_vector(Sum) when phase = third else (others => '0');
end architecture;
RTL
cat > rtl/b_kinds.vhd << 'RTL'
package kinds is
  type phase_t is (first, second, third);
end package;
RTL
cat > rtl/c_store.vhdl << 'RTL'
library ieee;
use ieee.std_logic_1164.all;
entity store is
  generic (N : positive);
  port (clk : in std_logic; d : in std_logic_vector(N-1 downto 0);
        q : out std_logic_vector(N-1 downto 0));
end entity;
architecture a of store is
  signal kept : std_logic_vector(N-1 downto 0) := (others => '1');
begin
  process (clk) begin
    if rising_edge(clk) then kept <= d; end if;
  end process;
  q <= kept;
end architecture;
RTL
"$program" new made rtl > said
diff - said << 'SAID'
made/: 2 inputs, 1 output, 3 registers; README.md has its two commands
made/made.h: next() is to be written
SAID
diff - <(grep -E 'FIELD\(|int |RST_N =' made/made.h) << 'TABLES'
  int WIDTH = 8;
// FIELD(name, width, format, its number in a printed source, meaning)
  FIELD(RST_N, 1, flag, "", "") \
  FIELD(D, p.WIDTH, bits, "", "")
  FIELD(Q, p.WIDTH, bits, "", "")
  FIELD(below_kept, p.WIDTH, bits.at("below.kept").unreset(), "", "") \
  FIELD(phase, 2, bits, "", "") \
  FIELD(sum, p.WIDTH, bits, "", "")
  static constexpr Inputs<Word> rest() { return {.RST_N = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.RST_N = 0}; }
TABLES
grep -q '^cosim_add_design(made SOURCES b_kinds.vhd a_top.vhd c_store.vhdl TOP top CLOCK CLK MODEL' \
  made/CMakeLists.txt

# A reset at the clock is seen, and a module of Verilog may have the entity.
cat > over.v << 'RTL'
module over(input wire clk, input wire [3:0] d, output wire [3:0] q);
  store4 one(.clk(clk), .d(d), .rst(d[0]), .q(q));
endmodule
RTL
cat > store4.vhd << 'RTL'
library ieee;
use ieee.std_logic_1164.all;
entity store4 is
  port (clk, rst : in std_logic; d : in std_logic_vector(3 downto 0);
        q : out std_logic_vector(3 downto 0));
end entity;
architecture a of store4 is
  signal kept : std_logic_vector(3 downto 0);
begin
  process (clk) begin
    if rising_edge(clk) then
      kept <= d;
      if rst = '1' then kept <= (others => '0'); end if;
    end if;
  end process;
  q <= kept;
end architecture;
RTL
"$program" new mixed over.v store4.vhd > said
grep -qF '  FIELD(one_kept, 4, bits.at("one.kept")' mixed/mixed.h
printf '%s\n' 'entity store4_tb is end entity; architecture a of store4_tb is' \
  'component store4 is port (clk : in std_logic); end component;' \
  'begin dut: store4 port map (clk); end architecture;' > store4_tb.vhd
"$program" new alone store4_tb.vhd store4.vhd > said
grep -qx 'store4_tb.vhd: a testbench, left out' said
# What another entity has an instance of is made with that one, for it alone has no width.
cat > wrap.v << 'RTL'
module wrap(input wire clk, input wire rst_n, input wire [7:0] d, output wire [7:0] q);
  top one(.CLK(clk), .RST_N(rst_n), .D(d), .Q(q));
endmodule
RTL
"$program" new wrapped wrap.v rtl/*.vhd* > said
grep -qF 'bits.at("one.below.kept")' wrapped/wrapped.h
grep -qF 'return {.rst = 1}; }' alone/alone.h

# Two versions are compared, with a parameter, and one of them may be Verilog.
sed 's/Sum <= Sum + unsigned(held)/Sum <= unsigned(held) + Sum/' rtl/a_top.vhd > a_top.vhd
same=(rtl/b_kinds.vhd rtl/c_store.vhdl)
ends 0 equiv --gold rtl/a_top.vhd "${same[@]}" --gate a_top.vhd "${same[@]}" --top top \
  --reset RST_N=0 --param WIDTH=9
says_like '^top: equal for ever'
sed 's/(others => .0.)/x"5"/' store4.vhd > other.vhd
ends 2 equiv --gold store4.vhd --gate other.vhd --top store4 --reset d --netlists
ends 1 equiv --gold store4.vhd --gate other.vhd --top store4 --netlists
says_like '^store4: different on clock'

# refused FILES: what is said of them, as one line.
refused() {
  ends 2 new bad "$@"
  [[ $(wc -l < said) == 1 && ! -e bad ]] || fails "it is a line, and nothing is left"
}
sed 's/kept <= d;/kept <= d + ;/' store4.vhd > broken.vhd
refused broken.vhd
says_like '^cosim: new: broken.vhd:1[0-9]:.*primary expression expected'
sed 's/end architecture/-- end/' store4.vhd > open.vhd
refused open.vhd
sed 's/if rising_edge(clk)/if clk/; s,entity work,work,' rtl/a_top.vhd > missing.vhd
refused missing.vhd
says 'missing.vhd:4:'
mkdir bin
for tool in sh perl cmake verilator verilator_bin env yosys rm mkdir; do
  real=$(command -v "$tool") || continue
  ln -s "$real" "bin/$tool"
done
PATH=$folder/bin ends 2 new bad store4.vhd
[[ $(< said) == "cosim: new: needs ghdl, which turns VHDL into Verilog" ]] || fails "it needs ghdl"
