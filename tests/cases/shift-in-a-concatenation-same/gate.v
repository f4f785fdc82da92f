module t(input [7:0] a, output [15:0] y);
  assign y = {8'd0, a[3:0], 4'd0};
endmodule
