// An inout port that the module drives where en is 1.
module t(input en, d, inout pad, output y);
  assign pad = en ? d : 1'bz;
  assign y = pad ^ d;
endmodule
