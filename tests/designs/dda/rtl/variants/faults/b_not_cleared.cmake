variant("A reset keeps B" W=16)
replace(dda.v [[b_q <= {W+1{1'b0}};]] [[b_q <= b_q;]])
