# shellcheck shell=bash
# No symbol can be what this model asks for: lanes are refused, and nothing is compared.
for lanes in 512 64; do
  ends 2 sweep largest --hostile 1000 --lanes "$lanes" --report refused.json
  says 'largest.h:25: a symbol is no number of C++'
  [[ $(wc -l < said) == 1 && ! -e refused.json ]] || fails "lanes of largest are refused in one line"
done
