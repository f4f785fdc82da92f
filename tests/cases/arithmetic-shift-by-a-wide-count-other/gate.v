module t(input signed [7:0] a, input [33:0] n, output signed [7:0] y);
  wire signed [7:0] few = a >>> n[2:0];
  assign y = n > 7 ? 8'd0 : few;
endmodule
