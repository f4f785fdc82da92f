# shellcheck shell=bash
# A plain model cannot be made into gates: lanes are refused, and nothing is compared.
for lanes in 512 64; do
  ends 2 sweep largest --hostile 1000 --lanes "$lanes" --report refused.json
  says 'largest FAULT=0: does not run in lanes: it has a plain model, on machine integers alone'
  [[ $(wc -l < said) == 1 && ! -e refused.json ]] || fails "lanes of largest are refused in one line"
done
