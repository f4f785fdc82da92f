module t(input clk, input rst, input [1:0] w, input r, d, output reg q, p);
  reg store[0:3];
  wire x = store[{r, 1'b0}];
  initial begin
    store[0] = 0;
    store[1] = 0;
    store[2] = 0;
    store[3] = 0;
    {p, q} = 0;
  end
  always @(posedge clk) begin
    store[w | 1] <= d;
    p <= x;
    q <= 0;
  end
endmodule
