-- The output begins at 2.
library ieee;
use ieee.std_logic_1164.all;
entity t is
  port (clk, e : in std_logic; y : buffer integer range 2 to (2 + 4));
end;
architecture rtl of t is
begin
  process (clk) begin
    if rising_edge(clk) and e = '1' then
      if y = 6 then y <= 2; else y <= y + 1; end if;
    end if;
  end process;
end;
