module t(input signed [3:0] a, output [3:0] y);
  assign y = 4'd0;
endmodule
