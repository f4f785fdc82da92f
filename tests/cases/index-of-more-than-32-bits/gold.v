module t(input [7:0] a, input [7:0] b, input [2:0] s, input e, output reg [7:0] y);
  reg [7:0] m [0:7];
  integer i;
  always @* begin
    for (i = 0; i < 8; i = i + 1) m[i] = a + i;
    m[{e, 29'd0, s}] = b;
    y = m[3];
  end
endmodule
