library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity t is port(a : in std_logic_vector(1 downto 0); y : out std_logic); end t;
architecture r of t is 
begin
  y <= '1' when a = "00" else '0';
end r;
