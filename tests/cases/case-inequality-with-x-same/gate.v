module t(input [3:0] a, input b, c, output y);
  assign y = (^a !== 1'bx) ? c : b;
endmodule
