library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity t is port(clk,rst: in std_logic; a,b: in unsigned(7 downto 0); s,u: in signed(7 downto 0); c: in std_logic_vector(3 downto 0); y: out unsigned(15 downto 0)); end;
architecture r of t is
 signal k: unsigned(15 downto 0);
 signal w: unsigned(15 downto 0);
 constant HC: std_logic:='H'; constant DC: std_logic_vector(3 downto 0):="1---";
begin
 process(clk) begin if rising_edge(clk) then if rst='1' then k<=(others=>'0'); else k<=k+1; end if; end if; end process;
 process(clk) begin if rising_edge(clk) then if rst='1' then y<=(others=>'0'); else y<=k xor w; end if; end if; end process;
 process(all) begin w<=(others=>'0'); if k=30000 and c(0)=HC then w<=x"0001"; end if; end process;
end;
