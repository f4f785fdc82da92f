module t(input c, input signed [3:0] s, input [3:0] u, output [7:0] y);
  assign y = c ? {{4{s[3]}}, s} : {4'd0, u};
endmodule
