// Both sides have the same file; what it includes is another one on each.
assign y = {a, "", b};
