interface bus;
  wire pad;
  modport target(inout pad);
endinterface
module t(input logic clk, bus.target p, output logic q);
  always_ff @(posedge clk) q <= p.pad;
endmodule
