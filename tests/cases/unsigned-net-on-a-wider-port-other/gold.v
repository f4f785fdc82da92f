// An unsigned net is extended with zeros, even on a signed port.
module below(input signed [7:0] i, output [3:0] o);
  assign o = i[7:4];
endmodule
module t(input  [3:0] a, output [3:0] y);
  below u(.i(a), .o(y));
endmodule
