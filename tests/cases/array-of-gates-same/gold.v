// An array of instances of a gate.
module t(input [3:0] a, b, output [3:0] y);
  and g[3:0](y, a, b);
endmodule
