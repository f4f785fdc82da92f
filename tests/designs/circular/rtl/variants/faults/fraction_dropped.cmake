variant("A load sets the fraction of F to .00" W=4)
replace(circular_accumulator.v [[loaded = {f, 1'b1, ~f[W+1]};]] [[loaded = {f, 2'b00};]])
