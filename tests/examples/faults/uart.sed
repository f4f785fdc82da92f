# The stop bit that is sent is the start bit again; one that comes may be anything.
s/frame <= \{1'b1,/frame <= {frame[0],/
s/valid = done & frame\[8\];/valid = done;/
