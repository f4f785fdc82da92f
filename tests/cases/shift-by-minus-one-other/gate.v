module t(input [7:0] a, output [7:0] y);
  assign y = {1'b0, a[7:1]};
endmodule
