module t(input clk, rst_n, input [3:0] by, output [3:0] q);
  reg [3:0] sum;
  always @(posedge clk) if (!rst_n) sum <= 0; else sum <= sum + by;
  assign q = sum;
endmodule
