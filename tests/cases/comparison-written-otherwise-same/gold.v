// Comparisons of another form.
module t(input clk, input rst, input [7:0] a, b, output reg eq, neq);
  always @(posedge clk) begin
    eq <= a == b;
    neq <= a != b;
  end
endmodule
