// return in a loop of a function.
module t(input [3:0] a, output [2:0] y);
  function automatic logic [2:0] lowest(logic [3:0] v);
    for (int i = 0; i < 4; i++)
      if (v[i]) return i;
    return 4;
  endfunction
  assign y = lowest(a);
endmodule
