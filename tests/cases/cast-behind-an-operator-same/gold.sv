// An operator of one operand in front of a cast, on a clock that a random stimulus does not come to.
module t(input clk, input rst, input [4:0] d, output logic q);
  logic [19:0] n;
  always_ff @(posedge clk)
    if (rst) begin
      n <= 0;
      q <= 0;
    end else begin
      n <= n + 1;
      q <= n == 20'h00ff0 ? |3'(d) : d[4];
    end
endmodule
