package c_pkg;
  import b_pkg::*;
  typedef logic [W-1:0] word_t;
  function automatic word_t turned(word_t x);
    return {x[0], x[W-1:1]};
  endfunction
endpackage
