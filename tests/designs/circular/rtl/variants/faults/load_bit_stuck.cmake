variant("The low bit of F is loaded as 1" W=16)
replace(circular_accumulator.v
  [[wire [W+3:0] loaded = {f, 1'b1, ~f[W+1]};]]
  [[wire [W+3:0] loaded = {f[W+1:1], 2'b11, ~f[W+1]};]])
