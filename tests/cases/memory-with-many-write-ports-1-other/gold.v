// What the statements leave in a memory counts, not how many write it.
module t(input clk, input rst, input we, sel, input [11:0] w, v, r, input [31:0] d, output reg [31:0] q);
  reg [31:0] store[0:3];
  always @(posedge clk) begin
    store[w] <= d;
    store[v] <= 0;
    q <= store[r];
  end
endmodule
