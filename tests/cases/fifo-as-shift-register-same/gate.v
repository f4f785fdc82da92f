module t(input clk, input rst, input push, pop, input [1:0] d, output [1:0] q, output empty, full);
  reg [1:0] s0, s1, s2, s3;
  reg [2:0] n;
  assign empty = n == 0, full = n == 4;
  assign q = n == 0 ? 0 : n == 1 ? s0 : n == 2 ? s1 : n == 3 ? s2 : s3;
  wire pu = push && !full, po = pop && !empty;
  always @(posedge clk) if (rst) n <= 0;
  else begin
    if (pu) begin
      s0 <= d;
      s1 <= s0;
      s2 <= s1;
      s3 <= s2;
    end
    n <= n + pu - po;
  end
endmodule
