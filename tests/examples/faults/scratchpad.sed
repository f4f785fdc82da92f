# One word is written although the line fills it.
s/if \(fill\) r/if (fill \& !(write \& target == g \& g == 13)) r/
