library ieee;
use ieee.std_logic_1164.all;
entity t is
  port (a, b : in std_logic; y : out std_logic);
end entity;
architecture rtl of t is
begin
  y <= a and b;
end architecture;
