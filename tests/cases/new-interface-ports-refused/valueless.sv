interface bus #(parameter int W);
  logic [W-1:0] a;
  modport target(input a);
endinterface
module t(input logic clk, bus.target p, output logic q);
  always_ff @(posedge clk) q <= ^p.a;
endmodule
