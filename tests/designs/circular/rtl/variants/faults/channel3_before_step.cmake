variant("Channel 3 has CT7 as it was before the step" W=16)
replace(circular_commutator.v
  [[wire moved = (channel3 & ct7_q[0]) | (channel2_down & ~ct7_q[0]);]]
  [[wire moved = channel2_down & ~ct7_q[0];]])
replace(circular_commutator.v
  [[wire lowest = channel1 ? ct8_lowest : ct7_q[0] ^ channel2_down;]]
  [[wire lowest = channel1 ? ct8_lowest : ct7_q[0] ^ (channel2_down | channel3);]])
