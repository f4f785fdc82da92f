// The count of a shift is unsigned, whatever its type.
module t(input [7:0] a, input signed [2:0] n, output [7:0] y);
  assign y = a >> n;
endmodule
