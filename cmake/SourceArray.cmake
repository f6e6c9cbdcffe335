# SPDX-License-Identifier: MIT
# Things of one kind, a source file each, as one array: adding one is its file and its line here.
#
# vides_source_array(TARGET FUNCTION TYPE HEADER FILES...)
#   Adds the files to the target, and a source that the build writes: it defines
#     std::span<const TYPE* const> FUNCTION();
#   as HEADER declares it, in the order of the files. Each file some_thing.cpp includes HEADER and
#   defines, in namespace vides, one
#     extern const TYPE kSomeThing{...};
#   Nothing registers itself at start: static libraries would drop it.
function(vides_source_array target function type header)
  set(declarations "")
  set(pointers "")
  foreach(file IN LISTS ARGN)
    get_filename_component(stem ${file} NAME_WE)
    string(REPLACE "_" ";" words ${stem})
    set(name k)
    foreach(word IN LISTS words)
      string(SUBSTRING ${word} 0 1 first)
      string(TOUPPER ${first} first)
      string(SUBSTRING ${word} 1 -1 rest)
      string(APPEND name ${first}${rest})
    endforeach()
    string(APPEND declarations "extern const ${type} ${name};  // ${file}\n")
    string(APPEND pointers " &${name},")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Written by cmake/SourceArray.cmake.
#include \"${header}\"

namespace vides {

${declarations}
std::span<const ${type}* const> ${function}() {
  static constexpr const ${type}* kAll[] = {${pointers}};
  return kAll;
}

}  // namespace vides
" @ONLY)
  target_sources(${target} PRIVATE ${ARGN} ${source})
endfunction()
