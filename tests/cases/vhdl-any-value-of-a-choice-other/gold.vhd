-- The new RTL may be any value where a(1) is 1.
library ieee;
use ieee.std_logic_1164.all;
entity t is
  port(a : in std_logic_vector(1 downto 0); y : out std_logic);
end t;
architecture r of t is
begin
  y <= '0' when a = "01" else '1';
end r;
