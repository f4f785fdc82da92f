library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity t is port(clk,rst: in std_logic; a,b: in std_logic; k: in std_logic; s: in std_logic_vector(1 downto 0); d: in unsigned(31 downto 0); v: in signed(7 downto 0); y: out std_logic; z: out std_logic_vector(7 downto 0)); end;
architecture r of t is
type mt is array(0 to 3) of std_logic; signal m: mt:=(others=>'0');
begin
process(clk) begin if rising_edge(clk) then m(to_integer(unsigned(s)))<=b; end if; end process; z<=(others=>'0'); y <= m(to_integer(unsigned(s))) when k='1' else a xor b;
end;
