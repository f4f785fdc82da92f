variant("The tick count of multiplier 6 has no carry from bit 2 to bit 3" M=16 N=13)
replace(linear_multiplier6.v
  [[wire [N-1:0] next_tick = ticks_q + ONE;]]
  [[wire [N-1:0] next_tick = {ticks_q[N-1:3], ticks_q[2:0] + ONE[2:0]};]])
