variant("A curve is over when X has no steps left" W=16)
replace(dda.v [[(~free_q & none_left_x & none_left_y);]] [[(~free_q & none_left_x);]])
