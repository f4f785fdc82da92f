module t(input [7:0] a, output [3:0] y);
  assign y = {2'b10, a[7:6]};
endmodule
