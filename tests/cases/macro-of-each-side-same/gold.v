// A macro of one side is not seen by the other.
`define LIMIT 3
`define OVER(v, n) ((v) > (n))
module t(input [3:0] a, output y);
  assign y = `OVER(a, `LIMIT);
endmodule
