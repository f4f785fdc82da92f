-- The quotient of signed values is signed.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity t is port (a, b : in signed(3 downto 0); q : out signed(3 downto 0)); end;
architecture rtl of t is begin
  q <= a / b when b /= 0 else "0000";
end;
