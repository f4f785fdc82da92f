interface bus;
  logic a [2];
  modport target(input a);
endinterface
module t(input logic clk, bus.target p [2], output logic q);
  always_ff @(posedge clk) q <= p[0].a[1] ^ p[1].a[0];
endmodule
