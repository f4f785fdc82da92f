// A localparam and a net of each turn of a loop.
module t(input [7:0] a, output [7:0] y);
  genvar i;
  generate
    for (i = 0; i < 8; i = i + 1) begin : turn
      localparam FROM = (i * 3) % 8;
      wire n = a[FROM];
      if (i == 0) assign y[i] = n;
      else assign y[i] = n ^ turn[i-1].n;
    end
  endgenerate
endmodule
