variant("The sum of an accumulator has no carry from bit 7 to bit 8" W=16)
replace(dda_axis.v [[
  assign {carry, next_s} = {1'b0, s} + {1'b0, rate[W-1:0]};
]] [[
  wire unread;
  wire [W-1:0] sum;
  assign {carry, sum} = {1'b0, s} + {1'b0, rate[W-1:0]};
  assign {unread, next_s} = {1'b0, s[W-1:8] + rate[W-1:8], s[7:0] + rate[7:0]};
]])
