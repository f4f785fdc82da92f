# shellcheck shell=bash
[[ ! $solvers ]] || { ends 0 prove synced FAULT=0 && says "3 clocks of a reset make them the same"; }
