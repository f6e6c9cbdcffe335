# SPDX-License-Identifier: MIT
# One interface target with what every target of ours is compiled with.
include(CheckCXXCompilerFlag)
include(CheckLinkerFlag)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(vides_options INTERFACE)
target_compile_features(vides_options INTERFACE cxx_std_20)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# The same sums on every machine of a kind: no contraction to fused multiply-add behind our back.
target_compile_options(vides_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off)
if(VIDES_WERROR)
  target_compile_options(vides_options INTERFACE -Werror)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
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

# Hardening, each flag only where the compiler knows it.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND NOT VIDES_SANITIZE AND NOT VIDES_TSAN)
  foreach(flag -fstack-protector-strong -fstack-clash-protection -fcf-protection
               -ftrivial-auto-var-init=zero)
    string(MAKE_C_IDENTIFIER "VIDES_HAS${flag}" known)
    check_cxx_compiler_flag(${flag} ${known})
    if(${known})
      target_compile_options(vides_options INTERFACE ${flag})
    endif()
  endforeach()
  target_compile_definitions(vides_options INTERFACE _FORTIFY_SOURCE=2 _GLIBCXX_ASSERTIONS)
  foreach(flag -Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
    string(MAKE_C_IDENTIFIER "VIDES_HAS${flag}" known)
    check_linker_flag(CXX ${flag} ${known})
    if(${known})
      target_link_options(vides_options INTERFACE ${flag})
    endif()
  endforeach()
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
