# shellcheck shell=bash
# What the scripts that run yosys share; sourced after lib.sh.
#   rtl                             the folder of the designs and of shipped.txt
#   check_shape DESIGN NAME=VALUE...  ends with status 2 where that is no design and its parameters
#   file_for_yosys FILE             the name in quotation marks; ends with status 2 where none hold it
#   read_rtl DESIGN NAME=VALUE...   yosys commands: the RTL at these parameters, the top's name kept
#   synthesis generic|ice40 DESIGN  yosys commands: from there to the netlist
#   each_shape COMMAND              runs COMMAND DESIGN NAME=VALUE... for each line of standard input,
#                                   some at a time, and prints what they print in the lines' order;
#                                   status 1 where one of them failed
# Their texts and files are made in `scratch`, a folder of this run.
# shellcheck disable=SC2154  # root and scratch are set by lib.sh
rtl=$root/rtl
make_scratch
export HOME=$scratch # where yosys keeps a history

check_shape() {
  local design=${1-} parameter
  [[ $design && -d $rtl/$design ]] || die "no such design: ${design:-none was named} (in $rtl)"
  for parameter in "${@:2}"; do
    [[ $parameter =~ ^[A-Z]+=[0-9]+$ ]] || die "no parameter: $parameter (such as W=16)"
    grep -qE "parameter +(integer +)?${parameter%=*} " "$rtl/$design/$design.v" ||
      die "$design has no parameter ${parameter%=*}"
  done
}

file_for_yosys() {
  [[ $1 != *[\"[:cntrl:]]* ]] || die "yosys cannot be given the name $1"
  local name=$1 special
  for special in \\ '*' '?' '['; do name=${name//"$special"/\\"$special"}; done
  echo "\"$name\""
}

read_rtl() {
  local top=$1 && shift
  local parameters=("${@/#/-chparam }")
  local file
  for file in "$rtl/$top"/*.v; do echo "read_verilog -defer $(file_for_yosys "$file");"; done
  echo "hierarchy -check -top $top ${parameters[*]/=/ };" \
    "rename -top $top;"
}

synthesis() {
  case $1 in
    generic) echo "synth -flatten -top $2;" ;;
    ice40) echo "synth_ice40 -abc9 -device hx -top $2;" ;;
    *) die "no such netlist: $1 (generic, ice40)" ;;
  esac
}

each_shape() {
  local number=0 count status=0 words
  while read -ra words; do
    while (($(jobs -rp | wc -l) >= $(nproc))); do wait -n || true; done
    ("$1" "${words[@]}" || touch "$scratch/failed") > "$scratch/shape.$number" &
    number=$((number + 1))
  done
  wait
  for ((count = number, number = 0; number < count; ++number)); do
    cat "$scratch/shape.$number"
  done
  [[ ! -e $scratch/failed ]] || status=1
  return "$status"
}
