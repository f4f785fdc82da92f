module t(input logic [7:0] a, input logic e, output logic [7:0] y);
  tri1 k;
  assign k = e ? a[0] : 1'bz;
  always_comb y = a ^ 8'(k & (a inside {[0:8]}));
endmodule
