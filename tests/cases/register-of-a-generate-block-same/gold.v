// A register of a generate block by its hierarchical name.
module t(input clk, rst, input [2:0] d, output y);
  genvar i;
  generate
    for (i = 0; i < 3; i = i + 1) begin : bit_of
      reg r;
      always @(posedge clk) r <= rst ? 0 : d[i];
    end
  endgenerate
  assign y = bit_of[0].r ^ bit_of[2].r;
endmodule
