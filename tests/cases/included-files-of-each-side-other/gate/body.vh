assign y = {a, b};
