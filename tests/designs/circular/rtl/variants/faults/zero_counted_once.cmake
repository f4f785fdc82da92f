variant("CT7 passes below zero into its second code of zero" W=4)
replace(circular_counter7.v [[lowest = ~ct7_q[0] & ~(down & ct7_zero);]] [[lowest = ~ct7_q[0];]])
