variant("D1: x' = Bx + 2Cy + E, without its minus sign" W=6)
replace(dda.v
  [[.add(x_down), .subtract(x_up), .result(turned_x)]]
  [[.add(x_up), .subtract(x_down), .result(turned_x)]])
replace(dda.v
  [[.add(y_down), .subtract(y_up), .result(next_rate_x)]]
  [[.add(y_up), .subtract(y_down), .result(next_rate_x)]])
