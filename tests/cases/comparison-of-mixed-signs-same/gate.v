module t(input signed [3:0] s, input [3:0] u, output y);
  assign y = {1'b0, s} < {1'b0, u};
endmodule
