variant("The steps of the two axes are on each other's pins" W=4)
replace(circular.v [[
  assign step_y = step & (straight_y | diagonal);
  assign step_x = step & (straight_x | diagonal);
]] [[
  assign step_y = step & (straight_x | diagonal);
  assign step_x = step & (straight_y | diagonal);
]])
