#!/usr/bin/env bash
# What tb/rooms.cmake finds in a small project: designs in the order of shipped.txt, studies by name, and
# without those that need something missing, each reported in a line. Files of tb include only their own
# folder and those below it in docs/pictures/rooms.svg, and docs/project/architecture.md names the same
# folders. First on a tree where each is wrong, then on the project.
# Status: 0 so it is, 1 not.
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

# finds TREE: what differs between its folders, the picture and the page, a line each.
finds() {
  cd "$1"
  local picture=docs/pictures/rooms.svg page=docs/project/architecture.md
  # Each room with the height of its box.
  sed -nE 's|.*<text x="[0-9]+" y="([0-9]+)">([a-z]+)[^a-z].*|\2 \1|p' $picture > "$folder/heights"
  cut -d ' ' -f 1 "$folder/heights" | LC_ALL=C sort > "$folder/drawn"
  { find tb -mindepth 1 -maxdepth 1 -type d -printf '%f\n' && echo model; } | LC_ALL=C sort |
    diff - "$folder/drawn" | sed -n "s|^< |$picture: no |p; s|^> |$picture: there is no |p" || true
  grep -vxE 'designs|studies|model' "$folder/drawn" |
    diff - <(sed '/^| other/,$d' $page | { grep -oE '^[|] [^ a-z-][a-z]+' || true; } |
      grep -oE '[a-z]+' | LC_ALL=C sort) |
    sed -n "s|^< |$page: no |p; s|^> |$page: too much: |p" || true
  # What a template includes by @NAME@ belongs to its user.
  { grep -rnoE '^#include "tb/[a-z]+/' tb || true; } | LC_ALL=C sort |
    awk -F '[/:"]' 'NR == FNR { split($0, one, " "); height[one[1]] = one[2]; next }
      $(NF - 1) != $2 && height[$(NF - 1)] <= height[$2] { print }' "$folder/heights" - |
    grep -vE '^tb/[a-z]+/[a-z_]+[.]cpp[.]in:' || true
}

mkdir -p tree/{tb/{one,beside,below,more},docs/{pictures,project}}
printf '<text x="1" y="%d">%s</text>\n' 10 one 10 beside 20 below 30 model/core 30 gone \
  > tree/docs/pictures/rooms.svg
printf '| \x60%s\x60 | |\n' one below extra > tree/docs/project/architecture.md
printf '#include "tb/%s/x.h"\n' one beside below > tree/tb/one/x.h
printf '#include "tb/%s/x.h"\n' beside below > tree/tb/below/x.h
diff - <(finds tree) <<- 'END'
	docs/pictures/rooms.svg: there is no gone
	docs/pictures/rooms.svg: no more
	docs/project/architecture.md: no beside
	docs/project/architecture.md: no gone
	docs/project/architecture.md: too much: extra
	tb/below/x.h:1:#include "tb/beside/
	tb/one/x.h:2:#include "tb/beside/
END
found=$(finds "$root")
[[ ! $found ]] || { echo "$found" && exit 1; }
echo "as expected"
