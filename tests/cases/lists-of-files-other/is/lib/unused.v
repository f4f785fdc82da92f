module unused(; // nobody has an instance of it
