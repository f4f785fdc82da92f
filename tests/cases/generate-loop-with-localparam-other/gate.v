module t(input [7:0] a, output [7:0] y);
  assign y = a ^ {a[6:0], 1'b0};
endmodule
