variant("The rate of Y never follows a step of X at once" W=6)
replace(dda.v [[.rate(sequential_q ? turned_y : rate_y_q),]] [[.rate(rate_y_q),]])
