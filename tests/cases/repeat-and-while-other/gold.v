// Loops of repeat and while with constant counts.
module t(input [7:0] a, output reg [7:0] y);
  integer n;
  always @* begin
    y = a;
    repeat (3) y = {y[6:0], y[7] ^ y[0]};
    n = 0;
    while (n < 2) begin
      y = y + 1;
      n = n + 1;
    end
  end
endmodule
