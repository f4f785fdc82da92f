module t(input logic clk, rst_n, input logic [3:0] a, output logic [3:0] q);
  always_ff @(posedge clk or negedge rst_n) if (!rst_n) q <= '0; else q <= a;
  assert property (@(posedge clk) disable iff (!rst_n) $past(a) == q);
  a2: assert property (@(posedge clk) $rose(a[0]) |-> !$stable(a));
endmodule
