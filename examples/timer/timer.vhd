-- A timer: `start` loads it; `load` + 2 clocks later `done` is high for a clock.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
entity timer is
  generic (WIDTH : positive := 8);
  port (clk, rst : in std_logic;
        start : in std_logic;
        load : in std_logic_vector(WIDTH-1 downto 0);
        busy : out std_logic;
        done : out std_logic);
end entity;
architecture rtl of timer is
  type state_t is (idle, running, ending);
  signal state : state_t := idle;
  signal count : unsigned(WIDTH-1 downto 0) := (others => '0');
  signal done_q : std_logic := '0';
begin
  process (clk)
  begin
    if rising_edge(clk) then
      done_q <= '0';
      case state is
        when idle =>
          if start = '1' then
            count <= unsigned(load);
            state <= running;
          end if;
        when running =>
          if count = 0 then
            state <= ending;
          else
            count <= count - 1;
          end if;
        when ending =>
          done_q <= '1';
          state <= idle;
      end case;
      if rst = '1' then
        state <= idle; count <= (others => '0'); done_q <= '0';
      end if;
    end if;
  end process;
  busy <= '1' when state /= idle else '0';
  done <= done_q;
end architecture;
