-- shift_right of a signed value keeps its sign.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity t is port (d : in std_logic_vector(3 downto 0); s : in unsigned(1 downto 0); y : out std_logic_vector(3 downto 0)); end;
architecture rtl of t is begin
  y <= std_logic_vector(shift_right(signed(d), to_integer(s)));
end;
