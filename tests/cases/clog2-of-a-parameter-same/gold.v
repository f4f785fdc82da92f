// $clog2(9) is 4.
module t #(parameter N = 9)(input [3:0] a, output [$clog2(N)-1:0] y);
  assign y = a;
endmodule
