// A loop that counts, over a variable of the block.
module t(input [6:0] a, output reg [2:0] y);
  integer i;
  always @* begin : count
    reg [2:0] n;
    n = 0;
    for (i = 6; i >= 0; i = i - 1) n = n + a[i];
    y = n;
  end
endmodule
