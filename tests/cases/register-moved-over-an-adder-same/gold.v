// A register behind an adder, and one at each of its inputs.
module t(input clk, input rst, input [7:0] a, b, output [8:0] q);
  reg [7:0] x, y;
  always @(posedge clk) begin
    x <= a;
    y <= b;
  end
  assign q = x + y;
endmodule
