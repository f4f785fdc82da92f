// The report would overwrite an input file.
module t(input [1:0] a, output [3:0] q);
  reg [3:0] m [3:0];
  initial begin
    m[0] = 1;
    m[1] = 2;
    m[2] = 4;
    m[3] = 8;
  end
  assign q = m[a];
endmodule
