# The names that no design may have: each design has a name space of its own in cosim, where the
# harness's headers declare things too. Those stand at the start of a line. What a model may have beside
# its step is looked up there too, as NAME(p, ...).
include_guard(GLOBAL)

# cosim_cpp_words(VARIABLE): the words of C++20.
function(cosim_cpp_words variable)
  set(${variable}
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t char32_t char8_t
    class co_await co_return co_yield compl concept const const_cast consteval constexpr constinit
    continue decltype default delete do double dynamic_cast else enum explicit export extern false float
    for friend goto if inline int long mutable namespace new noexcept not not_eq nullptr operator or or_eq
    private protected public register reinterpret_cast requires return short signed sizeof static
    static_assert static_cast struct switch template this thread_local throw true try typedef typeid
    typename union unsigned using virtual void volatile wchar_t while xor xor_eq
    PARENT_SCOPE)
endfunction()

# cosim_taken_names(VARIABLE): a list of "NAME HEADER".
function(cosim_taken_names variable)
  cmake_path(SET root NORMALIZE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../..)
  get_property(all GLOBAL PROPERTY COSIM_TAKEN_NAMES)
  if(NOT all)
    # Those of libraries, which are looked up there as well.
    set(all "std <cstdint>" "fmt <fmt/core.h>" "nlohmann <nlohmann/json.hpp>")
    file(GLOB headers RELATIVE ${root}
      ${root}/model/core/*.h ${root}/tb/*/*.h)
    foreach(header IN LISTS headers)
      file(STRINGS ${root}/${header} lines
        REGEX "^[a-zA-Z]|^__extension__ |^..(noreturn|gnu::cold)|^}  // namespace | [a-z_]+[(]p_?, [a-z_]+[,)]")
      list(FILTER lines EXCLUDE REGEX "^template <.*>$|^ *//")
      list(TRANSFORM lines REPLACE "^__extension__ |^..(noreturn|gnu::cold).. |(alignas|decltype)[(][a-z0-9]*[)]" "")
      set(inside "")  # a name space in cosim: what is declared there is in nobody's way
      foreach(line IN LISTS lines)
        set(name "")
        if(line MATCHES "^}  // namespace (cosim::)?(.*)$")
          if(CMAKE_MATCH_2 STREQUAL inside)
            set(inside "")
          endif()
        elseif(header MATCHES "^model/|job" AND line MATCHES "^ .* ([a-z_]+)[(]p_?, [a-z_]+[,)]")
          set(name ${CMAKE_MATCH_1})
        elseif(inside)
        elseif(line MATCHES "^namespace (cosim::)?([a-zA-Z_0-9]+) ")
          set(name ${CMAKE_MATCH_2})
          if(NOT name STREQUAL cosim)
            set(inside ${name})
          endif()
        elseif(line MATCHES "^(struct|class|enum class|enum|union) +([a-zA-Z_0-9]+)")
          set(name ${CMAKE_MATCH_2})
        elseif(line MATCHES "^([a-zA-Z][^(={;]*[ *&>])?[(]?[*]?([a-zA-Z_0-9]+)([(){;]| [={]|$)")
          set(name ${CMAKE_MATCH_2})
        endif()
        if(name)
          list(APPEND all "${name} ${header}")
        endif()
      endforeach()
    endforeach()
    list(REMOVE_DUPLICATES all)
    set_property(GLOBAL PROPERTY COSIM_TAKEN_NAMES "${all}")
  endif()
  set(${variable} "${all}" PARENT_SCOPE)
endfunction()
