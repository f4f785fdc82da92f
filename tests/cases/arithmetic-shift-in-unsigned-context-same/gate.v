module t(input signed [7:0] s, input [7:0] u, output [7:0] y);
  assign y = {1'b0, s[7:1]} + u;
endmodule
