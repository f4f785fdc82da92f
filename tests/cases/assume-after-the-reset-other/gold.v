// An assumption holds on earlier clocks too, but not in the reset.
module t(input clk, input rst, input a, b, output q);
  reg s, t;
  assign q = s & t;
  always @(posedge clk) begin
    s <= a;
    t <= b;
  end
endmodule
