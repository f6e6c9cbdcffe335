# SPDX-License-Identifier: MIT
# One interface target with what every target of ours is compiled with.
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)
include(CheckLinkerFlag)
include(CheckPIESupported)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(vides_options INTERFACE)
target_compile_features(vides_options INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Position-independent throughout: the program can be loaded anywhere, the core into any library.
check_pie_supported(LANGUAGES CXX)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# The same sums on every machine of a kind: no contraction to fused multiply-add behind our back.
target_compile_options(vides_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # Clang's -Wconversion takes in the change of sign, which GCC's leaves out for C++.
  target_compile_options(vides_options INTERFACE -Wno-sign-conversion)
endif()
if(VIDES_WERROR)
  target_compile_options(vides_options INTERFACE -Werror)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# The standard library checks indices and preconditions in every build: an abort, not an overrun.
target_compile_definitions(vides_options INTERFACE _GLIBCXX_ASSERTIONS)

if(VIDES_SANITIZE AND VIDES_TSAN)
  message(FATAL_ERROR "VIDES_SANITIZE and VIDES_TSAN exclude each other")
endif()
if(VIDES_SANITIZE)
  target_compile_options(vides_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(vides_options INTERFACE -fsanitize=address,undefined)
endif()
if(VIDES_TSAN)
  target_compile_options(vides_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(vides_options INTERFACE -fsanitize=thread)
endif()
if(VIDES_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "VIDES_FUZZ needs clang: cmake --preset fuzz")
  endif()
  # Coverage for all code; the main function comes with -fsanitize=fuzzer, only into the targets.
  target_compile_options(vides_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Hardening, each flag only where the compiler knows it. (GCC 12 lacks -fhardened and
# -fstrict-flex-arrays=3.)
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT VIDES_SANITIZE AND NOT VIDES_TSAN)
  foreach(flag -fstack-protector-strong -fstack-clash-protection -fcf-protection
               -ftrivial-auto-var-init=zero)
    string(MAKE_C_IDENTIFIER "VIDES_HAS${flag}" known)
    check_cxx_compiler_flag(${flag} ${known})
    if(${known})
      target_compile_options(vides_options INTERFACE ${flag})
    endif()
  endforeach()

  # Level 3 also checks sizes known only at run time; older C libraries stop at 2. Some
  # distributions define it for every build: take theirs back first.
  set(CMAKE_REQUIRED_FLAGS "-O2 -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3")
  check_cxx_source_compiles("
    #include <cstdio>
    #if !defined(__USE_FORTIFY_LEVEL) || __USE_FORTIFY_LEVEL < 3
    #error \"not known\"
    #endif
    int main() {}" VIDES_HAS_FORTIFY_3)
  unset(CMAKE_REQUIRED_FLAGS)
  if(VIDES_HAS_FORTIFY_3)
    target_compile_options(vides_options INTERFACE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3)
  else()
    target_compile_options(vides_options INTERFACE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2)
  endif()

  foreach(flag -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack -Wl,--as-needed)
    string(MAKE_C_IDENTIFIER "VIDES_HAS${flag}" known)
    check_linker_flag(CXX ${flag} ${known})
    if(${known})
      target_link_options(vides_options INTERFACE ${flag})
    endif()
  endforeach()
endif()
