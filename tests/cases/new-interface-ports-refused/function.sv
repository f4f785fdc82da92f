interface bus;
  logic valid, ready;
  function automatic logic fire(); return valid && ready; endfunction
  modport target(input valid, output ready, import fire);
endinterface
module t(input logic clk, bus.target p, output logic q);
  always_ff @(posedge clk) q <= p.fire();
  assign p.ready = 1;
endmodule
