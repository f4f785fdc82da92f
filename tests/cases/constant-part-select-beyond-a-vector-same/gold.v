// The bits of a part-select that are beyond the vector are x.
module t(input [7:0] a, output [3:0] y);
  assign y = a[6 +: 4];
endmodule
