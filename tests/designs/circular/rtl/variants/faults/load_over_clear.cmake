variant("A load of CT7 wins over a clear" W=16)
replace(circular_counter7.v [[
    if (clear) ct7_q <= {W+1{1'b0}};
    else if (take) ct7_q <= &ct7 ? {W+1{1'b0}} : ct7;
]] [[
    if (take) ct7_q <= &ct7 ? {W+1{1'b0}} : ct7;
    else if (clear) ct7_q <= {W+1{1'b0}};
]])
