assign q = |3'(d);
