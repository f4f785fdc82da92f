// A write to a bit beyond the vector writes nothing.
module t(input [3:0] n, input d, output reg [9:0] y);
  always @* begin
    y = 0;
    y[n] = d;
  end
endmodule
