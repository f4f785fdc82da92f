-- The state begins as a.
library ieee;
use ieee.std_logic_1164.all;
entity t is port (clk, e : in std_logic; y : out std_logic_vector(1 downto 0)); end;
architecture rtl of t is
  type state_t is (a, b, c);
  signal s : state_t;
begin
  process (clk) begin
    if rising_edge(clk) then
      case s is
        when a => if e = '1' then s <= b; end if;
        when b => s <= c;
        when c => s <= a;
      end case;
    end if;
  end process;
  y <= "00" when s = a else "01" when s = b else "10";
end;
