module t(input clk, input rst, input we, sel, input [11:0] w, v, r, input [31:0] d, output reg [31:0] q);
  reg [31:0] store[0:4095];
  always @(posedge clk) begin
    if (we && sel) store[v] <= ~d;
    if (we && !sel) store[w] <= d;
    q <= store[r];
  end
endmodule
