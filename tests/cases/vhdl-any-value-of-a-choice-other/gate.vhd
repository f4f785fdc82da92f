library ieee;
use ieee.std_logic_1164.all;
entity t is
  port(a : in std_logic_vector(1 downto 0); y : out std_logic);
end t;
architecture r of t is
begin
  with a select y <= '0' when "01", '1' when "00", '-' when others;
end r;
