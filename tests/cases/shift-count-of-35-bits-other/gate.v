module t(input [7:0] a, input [34:0] n, output [7:0] y);
  assign y = n[4:0] > 7 ? 8'd0 : a << n[2:0];
endmodule
