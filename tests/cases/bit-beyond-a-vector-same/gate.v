module t(input [9:0] a, input [3:0] n, output y);
  wire [15:0] w = {6'd0, a};
  assign y = w[n];
endmodule
