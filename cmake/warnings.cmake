# Warnings and sanitizers shared by every target of this project, and by none of its users.
add_library(obrys_warnings INTERFACE)
target_compile_options(obrys_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Wold-style-cast
  -Woverloaded-virtual -Wnull-dereference -Wimplicit-fallthrough
  $<$<BOOL:${OBRYS_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports false positives of these inside the standard library at -O2; of the last one (std::optional) in large
  # translation units and with sanitizers. The sanitizers and clang look for what it means.
  target_compile_options(obrys_warnings INTERFACE -Wno-null-dereference -Wno-restrict -Wno-maybe-uninitialized)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # What GCC's -Wconversion leaves out in C++; names of files that are compiled together, which GCC tells apart.
  target_compile_options(obrys_warnings INTERFACE -Wno-sign-conversion -Wno-shadow)
endif()
if(OBRYS_CORE)
  # Where sizes have 32 bits, our 64 of indices and tags are narrowed; texts and lists of 4 GiB do not come up there.
  target_compile_options(obrys_warnings INTERFACE -Wno-shorten-64-to-32 -Wno-unused-function)
endif()
if(OBRYS_SANITIZE)
  # float-cast-overflow is no part of GCC's undefined. The test house.casts finds by it who casts a double to an integer
  # by himself. Division by zero stays out: it is defined (infinite, NaN), and both are asked for afterwards.
  add_compile_options(-fsanitize=address,undefined,float-cast-overflow
    -fno-sanitize-recover=undefined,float-cast-overflow -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined,float-cast-overflow)
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
if(OBRYS_RACES)
  add_compile_options(-fsanitize=thread)
  add_link_options(-fsanitize=thread)
endif()
if(OBRYS_FUZZ)
  # Coverage feedback from every folder; only the fuzz programs themselves link libFuzzer's main.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
