module t(input clk, rst_n, input [3:0] by, output [3:0] q);
  reg [3:0] sum;
  wire [3:0] minus = ~by + 1;
  always @(posedge clk) sum <= rst_n ? sum - minus : 0;
  assign q = sum;
endmodule
