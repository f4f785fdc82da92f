module t(input c, input signed [3:0] s, input [3:0] u, output [7:0] y);
  assign y = {4'd0, c ? s[3:0] : u};
endmodule
