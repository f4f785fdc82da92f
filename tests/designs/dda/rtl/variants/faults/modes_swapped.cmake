variant("The bits of normalise and free are exchanged" W=6)
replace(dda.v
  [[else if (take & address == 4'd0) {free_q, normalise_q, sequential_q} <= data[2:0];]]
  [[else if (take & address == 4'd0) {normalise_q, free_q, sequential_q} <= data[2:0];]])
