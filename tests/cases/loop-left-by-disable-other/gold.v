// disable leaves a named block: the lowest bit that is 1.
module t(input [3:0] a, output reg [2:0] y);
  integer i;
  always @* begin : search
    y = 4;
    for (i = 0; i < 4; i = i + 1)
      if (a[i]) begin
        y = i;
        disable search;
      end
  end
endmodule
