interface bus(input logic clk);
  logic valid, ready, fire;
  assign fire = valid && ready;
  modport target(input valid, fire, output ready);
endinterface
module t(input logic clk, bus.target p, output logic q);
  always_ff @(posedge clk) q <= p.fire;
  assign p.ready = 1;
endmodule
