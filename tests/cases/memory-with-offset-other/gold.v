// A memory [4:7] begins at word 4.
module t(input clk, we, input [2:0] a, input [1:0] d, output [1:0] q);
  reg [1:0] m [4:7];
  always @(posedge clk) if (we) m[a] <= d;
  assign q = a[2] ? m[a] : 2'd0;
endmodule
