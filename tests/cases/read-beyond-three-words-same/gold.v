// Word 3 of 3 is x: any value will do.
module t(input clk, rst, we, input [1:0] wa, ra, input [3:0] d, output [3:0] q);
  reg [3:0] m [0:2];
  always @(posedge clk) if (we) m[wa] <= d;
  assign q = m[ra];
endmodule
