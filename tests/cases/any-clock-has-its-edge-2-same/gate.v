module t(input a, b, rst, input [1:0] d, output [1:0] q);
  reg [1:0] x, y;
  assign q = ~y;
  always @(posedge a) x <= rst ? 3 : ~d;
  always @(posedge b) y <= rst ? 3 : x;
endmodule
