module t(input [7:0] a, output [1:0] y);
  assign y = {a[7], a[7]};
endmodule
