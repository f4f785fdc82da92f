# One tap is wrong for one sample.
s/= x1 \+ x3;/= x1 + x3 + (x3 == 3);/
