variant("L1: the carry of counter 4 deselects ROM 11, whether or not there is a remainder" M=5 N=2)
replace(linear.v [[.chip_select(~(carry & remainder)),]] [[.chip_select(~carry),]])
