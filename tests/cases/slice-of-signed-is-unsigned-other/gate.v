module t(input signed [3:0] s, output [7:0] y);
  assign y = {{4{s[3]}}, s};
endmodule
