module t(input clk, input rst_n, input a, output y);
  reg [1:0] r;
  always @(posedge clk) r <= {r[0], rst_n};
  reg [1:0] s;
  always @(posedge clk) if (!r[1]) s <= 0;
  else if (a) s <= s == 2 ? 0 : s + 1;
  assign y = s == 2;
endmodule
