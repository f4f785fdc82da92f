variant("A clear sets F to 0 instead of 0.75" W=16)
replace(circular_accumulator.v [[f_q <= {{(W+2){1'b0}}, 2'b11};]] [[f_q <= {(W+4){1'b0}};]])
