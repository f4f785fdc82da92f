module t(input clk, rst, input [3:0] d, output [3:0] y);
  reg [3:0] a [3:0];
  reg [2:0] n;
  integer i;
  always @(posedge clk or posedge rst)
    if (rst) begin
      n <= 0;
      for (i = 0; i < 4; i = i + 1) a[i] <= 0;
    end else begin
      a[n[1:0]] <= d;
      n <= n + 1;
    end
  assign y = a[0] ^ a[1] ^ a[2] ^ a[3];
endmodule
