// The default of DEPTH is large, the value given is not.
module t #(parameter DEPTH = 16384)(input clk, we, input [5:0] a, input [31:0] d, output reg [31:0] q);
  reg [31:0] m [0:DEPTH-1];
  always @(posedge clk) begin
    if (we) m[a] <= d;
    q <= m[a];
  end
endmodule
