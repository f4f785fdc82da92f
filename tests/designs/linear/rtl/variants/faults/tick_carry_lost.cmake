variant("The tick count of multiplier 6 has no carry from bit 2 to bit 3" M=16 N=13)

replace(linear_multiplier6.v [[
  assign next_tick = ticks + ONE;
]] [[
  assign next_tick = {ticks[N-1:3], ticks[2:0] + ONE[2:0]};
]])
