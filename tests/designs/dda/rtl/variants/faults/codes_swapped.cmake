variant("The codes of X and Y are exchanged" W=6)
replace(dda.v [[
  assign code_x = x_q;
  assign code_y = y_q;
]] [[
  assign code_x = y_q;
  assign code_y = x_q;
]])
