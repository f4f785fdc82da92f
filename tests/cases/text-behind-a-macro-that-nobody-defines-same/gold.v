module t(input clk, input d, output reg q, output r);
`ifdef NEVER
  always @(posedge clk) begin #0 $strobe("%b", d); end
`elsif NOR_THIS
  reg n = 0;
  always @(posedge clk) assert (d) else n = 1;
`else
  assign r = d;
`endif
`ifndef SYNTHESIS
  always @(posedge clk) #1 $display("%b", q);
`else
  always @(posedge clk) q <= d;
`endif
endmodule
