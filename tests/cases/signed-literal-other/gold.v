// 4'shf is -1.
module t(input signed [7:0] a, output y);
  assign y = a == 4'shf;
endmodule
