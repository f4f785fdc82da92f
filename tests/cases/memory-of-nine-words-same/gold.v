// Address 9 and above: nothing is written, and what is read is x.
module t(input clk, we, input [8:0] a, input [3:0] d, output reg [3:0] q);
  reg [3:0] mem [0:8];
  always @(posedge clk) begin
    if (we) mem[a] <= d;
    q <= mem[a];
  end
endmodule
