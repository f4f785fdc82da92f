variant("T16 is not held between input 34 and the start" W=16)
replace(circular_control.v [[t16_q <= t16_q | sector2;  // (18)]] [[t16_q <= sector2;]])
