// What is read from a memory is equal where both get the same.
module t(input clk, input rst, input we, input [11:0] w, r, input [31:0] d, output reg [31:0] q);
  reg [31:0] store[0:1];
  always @(posedge clk) begin
    if (we) store[w] <= d;
    q <= store[r];
  end
endmodule
