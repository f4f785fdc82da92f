// Two clocks, an asynchronous reset and a memory.
module t(input w, r, a, e, d, output reg q);
  reg p;
  reg s[0:1];
  always @(posedge w) p <= d;
  always @(posedge w) if (e) s[a] <= p ^ d;
  always @(posedge r) q <= s[~a];
endmodule
