variant("No reset reaches T16" W=4)
replace(circular_control.v [[
      t4_q <= 1'b0;
      t16_q <= 1'b0;
]] [[
      t4_q <= 1'b0;
]])
