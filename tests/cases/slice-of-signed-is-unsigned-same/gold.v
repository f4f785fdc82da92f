// A part-select is unsigned, even if it selects the whole of a signed net.
module t(input signed [3:0] s, output [7:0] y);
  assign y = s[3:0];
endmodule
