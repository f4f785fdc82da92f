variant("A step of X changes the rate of Y by 2 C" W=6)
replace(dda.v [[.rate(rate_y_q), .by(two_a_q),]] [[.rate(rate_y_q), .by(two_c_q),]])
