module t(input clk, we, input [1:0] a, input [3:0] d, output reg [3:0] q);
  reg [3:0] m [0:3];
  always @(posedge clk) begin
    if (we) m[a] = d;
    q <= m[a];
  end
endmodule
