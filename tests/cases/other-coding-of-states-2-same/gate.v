module t(input clk, input rst, output reg [5:0] q);
  reg [5:0] b;
  integer i;
  always @* begin
    b[5] = q[5];
    for (i = 4; i >= 0; i = i - 1) b[i] = b[i+1] ^ q[i];
  end
  wire [5:0] n = b + 1;
  always @(posedge clk) if (rst) q <= 0;
  else q <= n ^ (n >> 1);
endmodule
