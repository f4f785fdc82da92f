module t(input logic clk, rst, bus.target s, bus.source m);
  always_ff @(posedge clk)
    if (rst) m.valid <= 1'b0;
    else if (m.ready | ~m.valid) begin
      m.valid <= s.valid;
      m.data <= s.data;
    end
  assign s.ready = ~(m.valid & ~m.ready);
endmodule
