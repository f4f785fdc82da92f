variant("A step of Y down is not counted" W=6)
replace(dda.v [[if (y_up | y_down) left_y_q <=]] [[if (y_up) left_y_q <=]])
