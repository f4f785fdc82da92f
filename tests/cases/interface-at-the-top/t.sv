module t(input logic clk, rst, bus.target s, bus.source m);
  always_ff @(posedge clk)
    if (rst) m.valid <= 0;
    else if (s.ready) begin
      m.valid <= s.valid;
      m.data <= s.data;
    end
  assign s.ready = m.ready || !m.valid;
endmodule
