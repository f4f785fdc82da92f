variant("C10: input 34 sets T16 at any time" W=4)
replace(circular_control.v [[t16_q | correct;  // (18)]] [[t16_q | correct | sector2;]])
