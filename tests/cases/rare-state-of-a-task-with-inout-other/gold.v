// yosys 0.23 reads the task as if k were an input alone; it is called after 5,000 clocks.
module t(input c, input [3:0] a, output reg [3:0] y);
  reg [15:0] n = 0;
  always @(posedge c) n <= n + 1;
  task twice(inout [3:0] k);
    k = k + k;
  endtask
  always @* begin
    y = a;
    if (n > 5000) twice(y);
  end
endmodule
