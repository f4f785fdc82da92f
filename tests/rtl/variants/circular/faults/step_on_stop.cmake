variant("A step is given on the clock that stops the arc" W=16)

replace(circular_control.v [[
  wire step    = t4_q & ~ct7_negative & ~stop & (t16_q | ~ct8_negative);
]] [[
  wire step    = t4_q & ~ct7_negative & (t16_q | ~ct8_negative);
]])
