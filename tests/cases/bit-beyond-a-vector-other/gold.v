// A bit beyond the vector is x; the new RTL may be anything there, the old one not.
module t(input [9:0] a, input [3:0] n, output y);
  assign y = n > 9 ? 1'b0 : a[n];
endmodule
