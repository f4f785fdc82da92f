// A decimal parameter from the command line is signed, as its default is.
module t #(parameter P = 3)(input [8:0] m, output k);
  assign k = $signed(m) < P;
endmodule
