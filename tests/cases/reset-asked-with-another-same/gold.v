module t(input clk, rst_n, srst, input [3:0] d, output reg [3:0] q, r);
  always @(posedge clk or negedge rst_n)
  begin : both
    if (srst || !rst_n) // both of them
    begin
      q <= 0; /* text */
      r <= 4'd3;
    end
    else if (d[0] || d[1]) begin
      q <= d; r <= q;
    end
  end
endmodule
