// The result of a signed function is extended with its sign.
module t(input signed [3:0] a, output signed [7:0] y);
  function signed [3:0] half(input signed [3:0] v);
    half = v >>> 1;
  endfunction
  assign y = half(a);
endmodule
