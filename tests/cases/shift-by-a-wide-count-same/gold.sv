module t(input clk, input [2:0] a, input [7:0] n, output reg [2:0] y, output reg [2:0] z, output less);
  always @(posedge clk) begin
    y = a;
    y <<= n;
    z[2:0] = a;
    z[2:0] >>= n;
  end
  assign less = $signed(a) < 'shf;
endmodule
