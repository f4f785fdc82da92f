variant("The sign of F is tested the wrong way round" W=4)

replace(circular_control.v [[
  wire   sector1_diagonal = step & ~t16_q &  f_negative;  // 2
  wire   sector2_diagonal = step &  t16_q & ~f_negative;  // 10
  assign straight_y       = step & ~t16_q & ~f_negative;  // 3
  assign straight_x       = step &  t16_q &  f_negative;  // 11
]] [[
  wire   sector1_diagonal = step & ~t16_q & ~f_negative;
  wire   sector2_diagonal = step &  t16_q &  f_negative;
  assign straight_y       = step & ~t16_q &  f_negative;
  assign straight_x       = step &  t16_q & ~f_negative;
]])
