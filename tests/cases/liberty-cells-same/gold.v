// Cells of a Liberty file.
module t(input clk, d, output q);
  reg r;
  always @(posedge clk) r <= ~d;
  assign q = r;
endmodule
