module t(input clk, input clk_b, a_rst, b_rst, input a, output y, output x);
  reg [1:0] s;
  always @(posedge clk) if (a_rst) s <= 0;
  else if (a) s <= s == 2 ? 0 : s + 1;
  assign y = s == 2;
  reg n;
  always @(posedge clk_b) n <= b_rst ? 1 : ~n;
  wire z = ~n;
  assign x = z;
endmodule
