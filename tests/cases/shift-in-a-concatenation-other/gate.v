module t(input [7:0] a, output [15:0] y);
  assign y = {4'd0, a, 4'd0};
endmodule
