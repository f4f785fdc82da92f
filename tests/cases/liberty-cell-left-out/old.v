module t(input ck, e, d, output reg q);
  wire g;
  ICG i(.CK(ck), .E(e), .G(g));
  always @(posedge g) q <= d;
endmodule
