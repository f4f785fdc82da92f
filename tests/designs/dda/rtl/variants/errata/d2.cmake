variant("D2: x' = -(By + 2Cy + E), with By where Bx is due" W=6)
replace(dda.v [[.rate(rate_x_q), .by(b_q),]] [[.rate(rate_x_q), .by({W+1{1'b0}}),]])
replace(dda.v [[.rate(turned_x), .by(two_c_q),]] [[.rate(turned_x), .by(b_q + two_c_q),]])
