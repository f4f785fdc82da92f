variant("A start wins over a stop" W=16)
replace(dda.v [[: start & ~stop;]] [[: start;]])
