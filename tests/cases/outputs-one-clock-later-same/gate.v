module t(input clk, input rst, input d, output reg q);
  reg p;
  always @(posedge clk) begin
    p <= rst ? 0 : d;
    q <= p;
  end
endmodule
