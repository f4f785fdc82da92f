variant("Variants -1 and -2 are taken for each other" W=4)
replace(circular_control.v [[
  assign variant1 = correct & ~ct8_lowest;  // (22)
  assign variant2 = correct &  ct8_lowest;  // (23)
]] [[
  assign variant1 = correct &  ct8_lowest;
  assign variant2 = correct & ~ct8_lowest;
]])
