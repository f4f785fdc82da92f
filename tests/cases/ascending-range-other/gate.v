module t(input [0:7] a, input [1:0] i, output [3:0] y);
  wire [7:0] d = a;
  assign y = {d[0], d[i +: 2], d[7 - i]};
endmodule
