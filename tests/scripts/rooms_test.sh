#!/usr/bin/env bash
# What tb/rooms.cmake finds in a small project: designs in the order of shipped.txt, studies by name, and
# without those that need something missing, each reported in a line. Status: 0 so it is, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
cd "$folder"

mkdir -p {rtl,model,tb/designs}/{second,first} tb/designs/unshipped model/{core,brought,other}
printf '# A comment.\nfirst W=4\nsecond W=4\nfirst W=8\n' > rtl/shipped.txt
# study NAME DESIGNS STUDIES MODELS
study() {
  mkdir -p "tb/studies/$1"
  printf 'set(STUDY_DESIGNS %s)\nset(STUDY_STUDIES %s)\nset(STUDY_MODELS %s)\n' "${@:2}" \
    > "tb/studies/$1/study.cmake"
}
study both "first second" "" brought
study after_both first both brought
study absent "first third" "" other
study needs_absent first "absent both" other
study again_absent "" needs_absent other
mkdir tb/designs/first/cli tb/studies/absent/cli
touch tb/designs/first/cli/x.cpp tb/studies/absent/cli/x.cpp
cat > CMakeLists.txt <<- END
	cmake_minimum_required(VERSION 3.25)
	project(rooms NONE)
	include($root/tb/rooms.cmake)
	room_sources(sources tb cli/*.cpp)
	string(REPLACE "$folder/" "" sources "\${sources}")
	foreach(list COSIM_SHIPPED COSIM_DESIGNS COSIM_STUDIES COSIM_MODELS sources)
	  message(STATUS "\${list}: \${\${list}}")
	endforeach()
END

diff - <(cmake -G Ninja -S . -B build | sed -n '/^-- Config/q; p') <<- 'END'
	-- design unshipped left out: no line in rtl/shipped.txt
	-- study absent left out: no design third
	-- study needs_absent left out: no study absent
	-- study again_absent left out: no study needs_absent
	-- COSIM_SHIPPED: first W=4;second W=4;first W=8
	-- COSIM_DESIGNS: first;second
	-- COSIM_STUDIES: after_both;both
	-- COSIM_MODELS: core;first;second;brought
	-- sources: tb/designs/first/cli/x.cpp
END

rm -r model/second
said=$(cmake -G Ninja -S . -B build 2>&1) && echo "takes a design without a model" && exit 1
[[ $said == *"rtl/shipped.txt: there is no folder model/second"* ]] || { echo "$said" && exit 1; }
echo "as expected"
