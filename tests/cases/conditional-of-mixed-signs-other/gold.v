// One unsigned branch makes the other one unsigned, too.
module t(input c, input signed [3:0] s, input [3:0] u, output [7:0] y);
  assign y = c ? s : u;
endmodule
