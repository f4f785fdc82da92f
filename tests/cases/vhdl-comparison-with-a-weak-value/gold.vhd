library ieee;
use ieee.std_logic_1164.all;
entity t is
  port (a, b : in std_logic; y : out std_logic);
end entity;
architecture rtl of t is
begin
  assert a /= 'X' report "a is unknown";
  y <= b when a = 'H' else '0';
end architecture;
