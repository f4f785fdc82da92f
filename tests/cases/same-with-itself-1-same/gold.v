// A shift register.
module t(input clk, input rst, input d, output q);
  reg [4:0] s;
  always @(posedge clk) s <= {s[3:0], d};
  assign q = s[4];
endmodule
