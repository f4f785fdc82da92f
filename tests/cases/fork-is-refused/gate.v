module t(input clk, d, output reg q, p);
  always @(posedge clk) begin
    q <= d;
    p <= ~d;
  end
endmodule
