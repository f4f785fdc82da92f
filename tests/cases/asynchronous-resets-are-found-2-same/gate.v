module t(input clk, input p, input q_n, input a, output y, output reg z);
  reg [1:0] s;
  always @(posedge clk or posedge p) if (p) s <= 0;
  else if (a) s <= s == 2 ? 0 : s + 1;
  assign y = s == 2;
  always @(posedge clk or negedge q_n) if (!q_n) z <= 0;
  else z <= y;
endmodule
