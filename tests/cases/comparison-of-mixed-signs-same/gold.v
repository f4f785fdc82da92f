// A comparison with one unsigned operand is unsigned.
module t(input signed [3:0] s, input [3:0] u, output y);
  assign y = s < u;
endmodule
