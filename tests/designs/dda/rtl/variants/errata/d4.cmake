variant("An axis that is done steps on, as nothing in the source stops it" W=6)
replace(dda.v [[.may_step(step & (free_q | ~none_left_x)),]] [[.may_step(step),]])
replace(dda.v [[.may_step(step & (free_q | ~none_left_y)),]] [[.may_step(step),]])
