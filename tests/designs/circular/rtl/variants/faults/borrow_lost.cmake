variant("CT8 has no borrow from bit 7 to bit 8" W=16)
replace(circular_counter8.v
  [[assign ct8_pairs = ct8_q[W:1] - {{(W-1){1'b0}}, 1'b1};]]
  [[assign ct8_pairs = {ct8_q[W:8], ct8_q[7:1] - 7'b1};]])
