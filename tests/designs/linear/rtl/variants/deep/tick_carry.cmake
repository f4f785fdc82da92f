variant("The tick count of multiplier 6 has no carry from bit 9 to bit 10" M=16 N=13)

replace(linear_multiplier6.v [[
  assign next_tick = ticks + ONE;
]] [[
  assign next_tick = {ticks[N-1:10], ticks[9:0] + ONE[9:0]};
]])
