variant("A step is given on the clock that stops the arc" W=16)
replace(circular_control.v
  [[assign step = t4_q & ~ct7_negative & ~stop & ~correct;]]
  [[assign step = t4_q & ~ct7_negative & ~correct;]])
