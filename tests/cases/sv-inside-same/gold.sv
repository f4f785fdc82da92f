// inside with a range and a wildcard.
module t(input [3:0] a, output y);
  assign y = a inside {4'd1, [4'd5:4'd7], 4'b11?0};
endmodule
