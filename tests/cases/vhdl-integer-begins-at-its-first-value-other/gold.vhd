-- The signal begins at 2.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity t is port (clk, e : in std_logic; y : out unsigned(2 downto 0)); end;
architecture rtl of t is
  signal c : integer range 2 to 6;
begin
  process (clk) begin
    if rising_edge(clk) and e = '1' then
      if c = 6 then c <= 2; else c <= c + 1; end if;
    end if;
  end process;
  y <= to_unsigned(c, 3);
end;
