// A wait in a process.
module t(input clk, d, e, output reg q);
  always @(posedge clk) begin
    wait (e);
    q <= d;
  end
endmodule
