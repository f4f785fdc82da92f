variant("CT8 takes no more for a diagonal step from 1" W=4)
replace(circular_counter8.v
  [[wire [1:0] two_lowest = ct8_zero_or_one ? {ct8_q[0], ~ct8_q[0]} : {~ct8_q[1], ct8_q[0]};]]
  [[wire [1:0] two_lowest = ~|ct8_q ? {ct8_q[0], ~ct8_q[0]} : {~ct8_q[1], ct8_q[0]};]])
