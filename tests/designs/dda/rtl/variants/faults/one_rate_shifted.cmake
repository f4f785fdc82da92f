variant("Only the rate of X is shifted" W=16)
replace(dda.v [[rate_y_q <= {rate_y_q[W-1:0], 1'b0};]] [[rate_y_q <= rate_y_q;]])
