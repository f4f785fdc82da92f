module t(input [3:0] a, b, output [7:0] y);
  wire [3:0] s = a + b;
  assign y = s;
endmodule
