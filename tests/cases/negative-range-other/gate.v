module t(input [3:-2] a, output [5:0] y);
  wire [5:0] d = a;
  assign y = {d[0], d[1:0], d[5:3]};
endmodule
