// $bits, $countones and $onehot.
module t(input [4:0] a, output [3:0] y);
  assign y = $countones(a) + $bits(a) + $onehot(a);
endmodule
