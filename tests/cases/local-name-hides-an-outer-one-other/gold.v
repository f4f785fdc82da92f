// A register of a named block hides the one of the module.
module t(input clk, rst, input [1:0] d, output reg [1:0] q);
  reg [1:0] n;
  always @(posedge clk) begin : inner
    reg [1:0] n;
    n = d + 1;
    q <= rst ? 0 : n;
  end
  always @* n = ~d;
endmodule
