// A bit of a net of an instance, by its hierarchical name.
module t(input [1:0] a, output y);
  below u(a);
  assign y = u.w[1];
endmodule
module below(input [1:0] i);
  wire [1:0] w = i;
endmodule
