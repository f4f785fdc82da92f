-- Every value of two bits is below 4.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity t is port (d : in unsigned(1 downto 0); y : out std_logic); end;
architecture rtl of t is begin
  y <= '1' when d < 4 else '0';
end;
