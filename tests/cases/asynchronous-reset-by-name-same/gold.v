// Registers with an asynchronous reset, matched by name.
module t(input clk, input rst_n, input [3:0] d, output reg [3:0] q, output reg p);
  reg [3:0] n;
  always @(posedge clk or negedge rst_n) if (!rst_n) begin
    n <= 5;
    q <= 0;
    p <= 1;
  end else begin
    n <= n + d;
    q <= n;
    p <= ^n;
  end
endmodule
