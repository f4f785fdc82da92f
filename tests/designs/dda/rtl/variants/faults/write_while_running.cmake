variant("A write is taken while a curve is drawn" W=16)
replace(dda.v [[wire take = write & ~running_q;]] [[wire take = write;]])
