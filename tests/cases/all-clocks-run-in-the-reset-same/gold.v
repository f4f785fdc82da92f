// A register without an initial value has what the reset gives it.
module t(input a, b, rst, input [1:0] d, output [1:0] q);
  reg [1:0] x = 0, y = 0;
  assign q = y;
  always @(posedge a) x <= rst ? 0 : d;
  always @(posedge b) y <= rst ? 0 : x;
endmodule
