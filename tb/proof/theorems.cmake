# A design with a file proof/theorems.cpp of its own has theorems, cosim::DESIGN::theorems().
set(THEOREM_DECLARATIONS "")
set(THEOREM_CALLS "")
file(GLOB found CONFIGURE_DEPENDS designs/*/proof/theorems.cpp)
foreach(path IN LISTS found)
  string(REGEX REPLACE ".*/([^/]*)/proof/theorems\\.cpp$" "\\1" design "${path}")
  string(APPEND THEOREM_DECLARATIONS
    "namespace cosim::${design} {\nstd::vector<proof::Theorem> theorems();\n}\n")
  list(APPEND THEOREM_CALLS "${design}::theorems()")
endforeach()
list(JOIN THEOREM_CALLS ", " THEOREM_CALLS)
configure_file(proof/all_theorems.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/all_theorems.cpp @ONLY)
