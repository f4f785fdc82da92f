module t(input clk, input rst, input a, b, output q);
  reg s, t;
  assign q = 1'b0;
  always @(posedge clk) begin
    s <= a & !rst;
    t <= b & !rst;
  end
endmodule
