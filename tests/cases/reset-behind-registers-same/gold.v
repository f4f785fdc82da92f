// The reset goes through two registers.
module t(input clk, input rst_n, input a, output y);
  reg [1:0] r;
  always @(posedge clk) r <= {r[0], rst_n};
  reg [2:0] s;
  always @(posedge clk) if (!r[1]) s <= 1;
  else if (a) s <= {s[1:0], s[2]};
  assign y = s[2];
endmodule
