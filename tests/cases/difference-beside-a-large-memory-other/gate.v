module t(input clk, input rst, input we, input [11:0] w, r, input [31:0] d, output reg [31:0] q, output reg [2:0] n);
  reg [31:0] store[0:4095];
  always @(posedge clk) begin
    if (we && n != 5) store[w] <= d;
    q <= store[r];
    n <= rst ? 0 : n + (we && n != 7);
  end
endmodule
