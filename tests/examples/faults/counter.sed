# The count before the last is taken for the last.
s/&total;/\&total[W-1:1];/
