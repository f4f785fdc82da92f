interface bus;
  logic a;
endinterface
module t(input logic clk, bus p, output logic q);
  always_ff @(posedge clk) q <= p.a;
endmodule
