module t(input w, r, rst_n, input d, output reg q);
  reg [1:0] n;
  reg s[0:3];
  always @(posedge w or negedge rst_n) if (!rst_n) n <= 1;
  else n <= {n[1], ~n[0]};
  always @(posedge w) s[n] <= d;
  always @(posedge r) q <= s[n];
endmodule
