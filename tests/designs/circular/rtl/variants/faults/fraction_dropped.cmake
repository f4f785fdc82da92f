variant("A load sets the fraction of F to .00" W=4)

replace(circular_accumulator.v [[
  wire [W+3:0] loaded = {f, 1'b1, ~f[W+1]};
]] [[
  wire [W+3:0] loaded = {f, 2'b00};
]])
