variant("What is subtracted from a rate is one too much" W=16)
replace(dda_change.v [[result = rate + term + {{W{1'b0}}, subtract};]] [[result = rate + term;]])
