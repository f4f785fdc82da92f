module t(input [3:0] a, output [7:0] y);
  wire [3:0] n = -a;
  assign y = {4'd0, n};
endmodule
