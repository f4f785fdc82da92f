library ieee;
use ieee.std_logic_1164.all;
use ieee.std_logic_arith.all;
use ieee.std_logic_unsigned.all;
entity t is
  port (clk, rst : in std_logic;
        d : in std_logic_vector(7 downto 0);
        q : out std_logic_vector(7 downto 0);
        below, wide : out std_logic);
end entity;
architecture rtl of t is
  signal c : std_logic_vector(7 downto 0) := (others => '0');
begin
  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        c <= (others => '0');
      elsif conv_integer(d) > 77 then
        c <= c + sxt(d(3 downto 0), 8);
      else
        c <= c - 1;
      end if;
    end if;
  end process;
  q <= c;
  below <= '1' when c < d(3 downto 0) else '0';
  wide <= '1' when unsigned(c) < signed(d) else '0';
end architecture;
