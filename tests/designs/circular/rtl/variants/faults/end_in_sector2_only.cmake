variant("In sector 1 an arc with CT7 below zero does not end" W=16)
replace(circular_control.v
  [[wire finish = t4_q & ct7_negative;]]
  [[wire finish = t4_q & ct7_negative & t16_q;]])
