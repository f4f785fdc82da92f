variant("The steps of the two axes are on each other's pins" W=4)

replace(circular.v [[
  assign step_y  = straight_y | diagonal;
  assign step_x  = straight_x | diagonal;
]] [[
  assign step_y  = straight_x | diagonal;
  assign step_x  = straight_y | diagonal;
]])
