variant("Output 22 falls with the last word formed" M=16 N=13)
replace(linear.v [[assign busy = trigger31_q;]] [[assign busy = trigger31_q & ~carry;]])
