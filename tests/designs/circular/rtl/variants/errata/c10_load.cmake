variant("C10: start values are taken at any time" W=4)
replace(circular_control.v [[assign take = load & ~t4_q;]] [[assign take = load;]])
