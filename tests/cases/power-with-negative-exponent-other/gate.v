module t(input signed [2:0] n, output [7:0] y);
  assign y = 8'd1 << n[1:0];
endmodule
