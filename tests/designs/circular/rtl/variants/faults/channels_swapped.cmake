variant("Channels 1 and 3 are each other's" W=4)
replace(circular.v [[
    .channel1(diagonal),
    .channel2_down(straight_x | variant2),
    .channel3(straight_y),
]] [[
    .channel1(straight_y),
    .channel2_down(straight_x | variant2),
    .channel3(diagonal),
]])
