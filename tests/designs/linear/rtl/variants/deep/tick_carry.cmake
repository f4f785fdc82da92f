variant("The tick count of multiplier 6 has no carry from bit 9 to bit 10" M=16 N=13)
replace(linear_multiplier6.v
  [[wire [N-1:0] next_tick = ticks_q + ONE;]]
  [[wire [N-1:0] next_tick = {ticks_q[N-1:10], ticks_q[9:0] + ONE[9:0]};]])
