// A user-defined primitive is read, or refused by its name.
primitive choose(o, s, a, b);
  output o;
  input s, a, b;
  table
    0 0 ? : 0;
    0 1 ? : 1;
    1 ? 0 : 0;
    1 ? 1 : 1;
    x 0 0 : 0;
    x 1 1 : 1;
  endtable
endprimitive
module t(input s, a, b, output y);
  choose u(y, s, a, b);
endmodule
