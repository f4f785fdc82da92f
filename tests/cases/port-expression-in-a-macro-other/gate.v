module t(input [7:0] a, input [7:0] b, output [15:0] y, output [15:0] z);
  wire [7:0] k = a + b, l = a + a;
  assign y = k;
  assign z = l;
endmodule
