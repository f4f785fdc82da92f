// A parameter from the command line may be negative.
module t #(parameter P = 3)(input [8:0] m, output k);
  assign k = $signed(m) < P;
endmodule
