module t import c_pkg::*; (input logic clk, input word_t d, output word_t q);
  always_ff @(posedge clk) q <= turned(d);
endmodule
