variant("The sign of F is tested the wrong way round" W=4)
replace(circular_control.v [[
  wire   sector1_diagonal = ~t16_q & ~ct8_negative &  f_negative;  // (2)
  assign straight_y       = ~t16_q & ~ct8_negative & ~f_negative;  // (3)
  wire   sector2_diagonal =  t16_q                 & ~f_negative;  // (10)
  assign straight_x       =  t16_q                 &  f_negative;  // (11)
]] [[
  wire   sector1_diagonal = ~t16_q & ~ct8_negative & ~f_negative;
  assign straight_y       = ~t16_q & ~ct8_negative &  f_negative;
  wire   sector2_diagonal =  t16_q                 &  f_negative;
  assign straight_x       =  t16_q                 & ~f_negative;
]])
