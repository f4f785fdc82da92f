module t(input clk, we, input [1:0] addr, input [3:0] di, output reg [3:0] do);
  reg [3:0] m [0:3];
  always @(posedge clk) begin
    if (we) m[addr] <= di;
    do <= m[addr];
  end
endmodule
