// Constants, types and a function of a package.
package lib;
  localparam W = 4;
  typedef logic [W-1:0] word_t;
  function automatic word_t twist(word_t v);
    return {v[0], v[W-1:1]};
  endfunction
endpackage
module t import lib::*; (input word_t a, output word_t y);
  assign y = lib::twist(a) ^ W;
endmodule
