# One flip-flop where there are to be two.
s/r_seen  <= r_first;/r_seen  <= r_gray;/
