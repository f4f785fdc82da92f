// The lowest bit of 8'bx0 is 0.
module t(input a, output [7:0] y);
  assign y = a ? 8'bx0 : 8'h00;
endmodule
