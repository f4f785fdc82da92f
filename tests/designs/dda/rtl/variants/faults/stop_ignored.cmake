variant("A stop does not stop" W=16)
replace(dda.v [[wire over = stop | (]] [[wire over = (]])
