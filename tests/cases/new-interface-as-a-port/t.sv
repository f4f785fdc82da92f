`default_nettype none
module t #(parameter int N = 2, parameter int LOW = 1) (
    input wire logic clk,
    bus.target s /* of the processor */,
    bus.source m [N], o [LOW:0],
    input wire logic [N-1:0] go
);
  always_ff @(posedge clk) begin
    if (s.valid) s.b <= {s.a, s.a ^ 16'(s.info.tag)};
    s.level <= s.kind == bus_pkg::WRITE ? -4'sd1 : 4'(s.t + s.c[0] + s.c[1]);
  end
  for (genvar i = 0; i < N; ++i) begin : g
    assign m[i].a = m[i].b[7:0];
    assign m[i].valid = go[i];
    assign m[i].kind = bus_pkg::IDLE;
  end
  for (genvar i = 0; i <= LOW; ++i) begin : h
    assign o[i].a = o[i].b[7:0];
    assign o[i].valid = s.clk;
    assign o[i].kind = bus_pkg::READ;
  end
endmodule
