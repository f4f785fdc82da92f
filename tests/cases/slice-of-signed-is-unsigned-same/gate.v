module t(input signed [3:0] s, output [7:0] y);
  assign y = {4'd0, s};
endmodule
