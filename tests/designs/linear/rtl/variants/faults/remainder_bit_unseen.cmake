variant("Detector 7 does not see the low bit of the remainder" M=5 N=2)
replace(linear.v [[wire remainder = |register5_q;]] [[wire remainder = |register5_q[GAMMA-1:1];]])
