module t(input clk, input [2:0] a, input [7:0] n, output reg [2:0] y, output reg [2:0] z, output less);
  always @(posedge clk) begin
    y <= n > 2 ? 3'd0 : a << n[1:0];
    z <= n > 2 ? 3'd0 : a >> n[1:0];
  end
  assign less = 1'b1;
endmodule
