interface bus;
  logic a;
  modport target(input a);
endinterface
module t(input logic clk, p_a, bus.target p, output logic q);
  always_ff @(posedge clk) q <= p.a ^ p_a;
endmodule
