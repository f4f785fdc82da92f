// The variable z has the value of a once, in the beginning.
module t(input clk, input [7:0] a, output logic [7:0] q);
  logic [7:0] z = a;
  always @(posedge clk) q <= z;
endmodule
