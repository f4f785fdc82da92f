// The complement has the width of the target.
module t(input [3:0] a, output [7:0] y);
  assign y = ~a;
endmodule
