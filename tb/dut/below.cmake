# The registers that a design's table has below the top module, at("instance.net").
include_guard(GLOBAL)

# cosim_nets_below(DESIGN): sets NETS_BELOW, for adapter_of.h.in, and SHOWN_BELOW, for registers.vlt.in.
# A row stands on one line of the table. In a netlist, which is flat, the path is the name of a net of
# the top; Verilator writes its dots in another way.
function(cosim_nets_below DESIGN)
  set(table ${PROJECT_SOURCE_DIR}/model/${DESIGN}/machine.h)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
  file(STRINGS ${table} rows REGEX "FIELD[(][a-z0-9_]+,.*at[(]\"[^\"]*[.]")
  set(nets "")
  set(shown "")
  foreach(row IN LISTS rows)
    string(REGEX MATCH "FIELD[(]([a-z0-9_]+),.*at[(]\"([^\"]+)\"" _ "${row}")
    set(name ${CMAKE_MATCH_1})
    set(path ${CMAKE_MATCH_2})
    string(REPLACE . __DOT__ inside ${DESIGN}.${path})
    string(REPLACE . __02e flat ${path})
    string(REGEX REPLACE "^.*[.]" "" net ${path})
    string(APPEND nets
      "  template <class Root>\n  static const auto& ${name}(const Root& root) {\n"
      "    if constexpr (requires { root.${inside}; }) return root.${inside};\n"
      "    else return root.${DESIGN}__DOT__${flat};\n  }\n")
    string(APPEND shown "public_flat_rd -module \"*\" -var \"${net}\"\n")
  endforeach()
  set(NETS_BELOW "${nets}" PARENT_SCOPE)
  set(SHOWN_BELOW "${shown}" PARENT_SCOPE)
endfunction()
