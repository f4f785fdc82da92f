module t(input clk, input rst, input we, sel, input [11:0] w, v, r, input [31:0] d, output reg [31:0] q);
  reg [31:0] store[0:3];
  always @(posedge clk) begin
    if (w != v) store[w] <= d;
    store[v] <= 0;
    q <= store[r];
  end
endmodule
