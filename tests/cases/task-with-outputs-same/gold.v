// A task with an output and an inout argument.
module t(input clk, rst, input [3:0] d, output reg [3:0] q, p);
  task step(input [3:0] v, output [3:0] o, inout [3:0] sum);
    begin
      sum = sum + v;
      o = sum ^ v;
    end
  endtask
  reg [3:0] n, s;
  always @(posedge clk)
    if (rst) {q, p} <= 0;
    else begin
      s = p;
      step(d, n, s);
      q <= n;
      p <= s;
    end
endmodule
