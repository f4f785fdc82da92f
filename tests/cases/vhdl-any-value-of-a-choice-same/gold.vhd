-- The choices that are left may be any value.
library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity t is port(a : in std_logic_vector(1 downto 0); y : out std_logic); end t;
architecture r of t is 
begin
  with a select y <= '1' when "00", '0' when "01", '-' when others;
end r;
