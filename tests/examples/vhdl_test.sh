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
made/made.h: clock() is to be written
SAID
diff - <(sed -n '/^template/p; /clock(/q; s/^ *\(.*[A-Za-z].*;\)$/\1/p' made/made.h) << 'MEMBERS'
template <int WIDTH>
Bit RST_N;
UInt<WIDTH> D;
UInt<WIDTH> Q;
static constexpr auto reset = active_low<&In::RST_N>;
static constexpr bool asynchronous_reset = true;
Unreset<At<"below.kept", UInt<WIDTH>>> kept;
UInt<2> phase = 0;
UInt<WIDTH> sum = 0;
MEMBERS
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
grep -qF 'At<"one.kept", UInt<4>>' mixed/mixed.h
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
grep -qF 'At<"one.below.kept", ' wrapped/wrapped.h
grep -qF 'reset = active_high<&In::rst>;' alone/alone.h

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

# What GHDL 2.0 turns into another Verilog: functions of numeric_std, constants of more than 32 bits, the
# default of a case.
cat > wrong.vhd << 'RTL'
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity wrong is
  port (a, b : in signed(2 downto 0); u : in unsigned(3 downto 0); n : in unsigned(2 downto 0);
        q0, q1, q2, q3, q4, q5 : out signed(2 downto 0); r0, r1, r2 : out unsigned(3 downto 0);
        s0 : out signed(1 downto 0); s1 : out unsigned(7 downto 0); c0, c1, c2 : out std_logic;
        k : out std_logic_vector(39 downto 0));
end entity;
architecture r of wrong is
begin
  q0 <= shift_right(a, to_integer(n));
  q1 <= a / b when b /= 0 else "000";
  q2 <= a rem b when b /= 0 else "000";
  q3 <= a mod b when b /= 0 else "000";
  q4 <= abs a;
  q5 <= 5 - a;
  r0 <= rotate_left(u, to_integer(n));
  r1 <= u ror to_integer(a);
  s0 <= resize(a, 2);
  s1 <= u * 20;
  c0 <= '1' when u < 16 else '0';
  c1 <= '1' when a /= 9 else '0';
  c2 <= '1' when -100 > a else '0';
  k <= x"123456789a" when n = 0 else (others => '1');
  with n select r2 <= u when "000", "0001" when "010", "0010" when "100", not u when others;
end architecture;
RTL
cat > wrong.v << 'RTL'
module wrong(input signed [2:0] a, b, input [3:0] u, input [2:0] n,
             output signed [2:0] q0, q1, q2, q3, q4, q5, output [3:0] r0, r1, r2,
             output [1:0] s0, output [7:0] s1, output c0, c1, c2, output [39:0] k);
  wire signed [2:0] d = a / b, m = a % b;
  wire [7:0] turned = {u, u} << n[1:0], back = {u, u} >> a[1:0];
  assign q0 = a >>> n, q1 = b == 0 ? 3'd0 : d, q2 = b == 0 ? 3'd0 : m;
  assign q3 = b == 0 ? 3'd0 : m == 0 || (m < 0) == (b < 0) ? m : m + b;
  assign q4 = a[2] ? -a : a, q5 = 3'd5 - a;
  assign r0 = turned[7:4], r1 = back[3:0];
  assign s0 = {a[2], a[0]}, s1 = 8'd4 * u;
  assign c0 = 1'b1, c1 = 1'b1, c2 = 1'b0;
  assign k = n == 0 ? 40'h123456789a : ~40'h0;
  assign r2 = n == 0 ? u : n == 2 ? 4'd1 : n == 4 ? 4'd2 : ~u;
endmodule
RTL
ends 0 equiv --gold wrong.vhd --gate wrong.v --top wrong
# A register written at an index, memories whose accesses are in an order, a value before the reset.
cat > order.vhd << 'RTL'
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity order is
  port (clk, rst : in std_logic; we : in std_logic_vector(1 downto 0); a, b : in unsigned(1 downto 0);
        d, e : in std_logic_vector(1 downto 0); q, y : out std_logic_vector(1 downto 0);
        z : out std_logic_vector(3 downto 0); w : out std_logic);
end entity;
architecture r of order is
  type memory is array (0 to 3) of std_logic_vector(1 downto 0);
  signal bits : std_logic_vector(3 downto 0) := "0110";
  signal first : std_logic := '1';
begin
  process (clk)
    variable fresh, last : memory := (others => "00");
  begin
    if rising_edge(clk) then
      if we(0) = '1' then fresh(to_integer(a)) := d; end if;
      q <= fresh(to_integer(b));
      y <= last(to_integer(b));
      if we(0) = '1' then last(to_integer(a)) := d; end if;
      if we(1) = '1' then last(to_integer(b)) := e; end if;
      if we(1) = '1' then bits(to_integer(a)) <= e(0); end if;
    end if;
  end process;
  process (clk, rst) begin
    if rst = '1' then first <= '0'; elsif rising_edge(clk) then first <= we(0); end if;
  end process;
  z <= bits;
  w <= first;
end architecture;
RTL
cat > order.v << 'RTL'
module order(input clk, rst, input [1:0] we, a, b, d, e, output reg [1:0] q, y, output reg [3:0] z,
             output reg w);
  reg [1:0] fresh [0:3], last [0:3];
  initial begin
    {w, z} = 5'b10110;
    {fresh[0], fresh[1], fresh[2], fresh[3], last[0], last[1], last[2], last[3]} = 0;
  end
  always @(posedge clk) begin
    if (we[0]) fresh[a] <= d;
    q <= we[0] && a == b ? d : fresh[b];
    y <= last[b];
    if (we[0]) last[a] <= d;
    if (we[1]) last[b] <= e;
    if (we[1]) z[a] <= e[0];
  end
  always @(posedge clk or posedge rst) if (rst) w <= 0; else w <= we[0];
endmodule
RTL
ends 0 equiv --gold order.vhd --gate order.v --top order
ends 0 equiv --gold order.v --gate order.vhd --top order --reset-clocks 0 --netlists
# Where GHDL would make it x, and so equal to anything, it is refused.
sed 's/first <= we(0)/first <= first/' order.vhd > lost.vhd
ends 2 equiv --gold lost.vhd --gate order.v --top order
says 'lost.vhd:27: GHDL gives first no value'
# numeric_std by its full name is not replaced.
sed 's/ resize(a, 2)/ ieee.numeric_std.resize(a, 2)/' wrong.vhd > named.vhd
ends 2 equiv --gold named.vhd --gate wrong.v --top wrong
says 'named.vhd:20: numeric_std.resize: '

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
for tool in sh cmake verilator verilator_bin env yosys rm mkdir; do
  real=$(command -v "$tool") || continue
  ln -s "$real" "bin/$tool"
done
PATH=$folder/bin ends 2 new bad store4.vhd
[[ $(< said) == "cosim: new: needs ghdl, which turns VHDL into Verilog" ]] || fails "it needs ghdl"
