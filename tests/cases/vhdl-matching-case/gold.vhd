library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity t is port (clk: in std_logic; d, e: in std_logic_vector(7 downto 0); y, z: out std_logic_vector(7 downto 0)); end;
architecture a of t is

begin
process(all) begin case? d(2 downto 0) is when "000" | "011" => y <= e; when "1-0" => y <= x"FF"; when others => y <= x"01"; end case?; z <= x"00"; end process;
end a;
