// Comments, underscores, addresses and a range in $readmemh.
module t(input [2:0] a, output [7:0] q);
  reg [7:0] m [0:7];
  initial begin
    $readmemh("low", m, 0, 3);
    $readmemh("high", m);
  end
  assign q = m[a];
endmodule
