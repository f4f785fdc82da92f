module t(input clk, rst, we, input [1:0] wa, ra, input [3:0] d, output [3:0] q);
  reg [3:0] m [0:2];
  always @(posedge clk) if (we) m[wa] <= d;
  assign q = ra == 3 ? 4'd9 : m[ra];
endmodule
