variant("Counter 4 has no borrow from bit 7 to bit 8" M=16 N=13)
replace(linear_counter4.v
  [[else if (up | down) counter4_q <= counter4_q + step;]]
  [[else if (up | down) counter4_q <= {counter4_q[N:8], counter4_q[7:0] + step[7:0]};]])
