// A header of Verilog-1995, and an implicit net.
module t(a, b, y);
  input [1:0] a;
  input b;
  output y;
  reg y;
  and g(n, a[1], b);
  always @(n or a) y = n ^ a[0];
endmodule
