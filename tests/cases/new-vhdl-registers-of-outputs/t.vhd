library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity t is
  port (clk, rst : in std_logic; d : in std_logic_vector(7 downto 0);
        q, q2 : out std_logic_vector(7 downto 0); v : out std_logic; parts : out std_logic_vector(3 downto 0));
end entity;
architecture rtl of t is
  signal both : unsigned(7 downto 0);
begin
  process (clk) begin
    if rising_edge(clk) then
      if rst = '1' then q <= (others => '0'); else q <= d; end if;
      both <= both + 1;
      parts(1 downto 0) <= d(1 downto 0);
      if rst = '0' then parts(3) <= d(2); end if;
    end if;
  end process;
  process (clk, rst) begin
    if rst = '1' then v <= '0'; elsif rising_edge(clk) then v <= d(0); end if;
  end process;
  q2 <= std_logic_vector(both);
  parts(2) <= '1';
end architecture;
