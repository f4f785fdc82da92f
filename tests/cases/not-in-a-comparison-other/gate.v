module t(input [3:0] a, input [7:0] b, output y);
  assign y = b == {4'h0, ~a};
endmodule
