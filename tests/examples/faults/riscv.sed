# A byte that is loaded from byte 3 of its word is not sign-extended.
s/is_signed = !funct3\[2\]/is_signed = !funct3[2] \&\& offset != 5'd24/
