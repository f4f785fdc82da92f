# One bit of the answer is lost.
s/\{shift\[6:0\], sampled\}/{shift[6:0], sampled \&\& bits != 3'd5}/
