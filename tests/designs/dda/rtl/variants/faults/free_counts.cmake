variant("The steps left are counted of a free curve, too" W=6)
replace(dda.v [[end else if (~free_q) begin]] [[end else begin]])
