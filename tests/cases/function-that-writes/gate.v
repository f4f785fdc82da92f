module t(input clk, rst, input [3:0] a, b, output reg [3:0] q, r, output [3:0] y, z);
  reg [3:0] last;
  assign y = a == 3 || b[1:0] == 2 ? {2'b0, a[1:0]} : 4'd9, z = ~b;
  always @(posedge clk)
    if (rst) begin
      last <= 0;
      q <= 0;
      r <= 0;
    end else begin
      q <= a == b ? ~a : last;
      if (a == b) last <= a + 1;
      if (b[0] & ~a[0]) r <= r + 1;
    end
endmodule
