// A delay of 5 before an assignment of a register: an edge within it is not seen.
module t(input clk, d, output reg q);
  always @(posedge clk) #5 q = d;
endmodule
