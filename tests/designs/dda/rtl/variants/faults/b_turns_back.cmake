variant("B changes the rate of X the wrong way" W=16)
replace(dda.v
  [[.by(b_q), .add(x_down), .subtract(x_up), .result(turned_x)]]
  [[.by(b_q), .add(x_up), .subtract(x_down), .result(turned_x)]])
