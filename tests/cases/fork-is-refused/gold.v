// A fork in a process.
module t(input clk, d, output reg q, p);
  always @(posedge clk)
    fork
      q <= d;
      p <= ~d;
    join
endmodule
