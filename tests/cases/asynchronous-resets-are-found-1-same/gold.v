// Each asynchronous reset is found.
module t(input clk, input power, input a, output y);
  reg [2:0] s;
  always @(posedge clk or negedge power) if (!power) s <= 1;
  else if (a) s <= {s[1:0], s[2]};
  assign y = s[2];
endmodule
