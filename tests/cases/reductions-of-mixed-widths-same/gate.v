module t(input signed [4:0] a, input [2:0] b, output [3:0] y);
  assign y = {3'd0, a == 5'h1f} + {3'd0, b[0] ^ b[1] ^ b[2]} - {3'd0, a == 0};
endmodule
