module t(input signed [3:0] a, input [3:0] b, output [3:0] y);
  wire [3:0] n = a;
  assign y = b == 0 ? 4'd0 : n / b;
endmodule
