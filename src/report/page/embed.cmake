# Writes OUT: one string_view for each of PARTS, named after the file ("page.js" -> page_js).
# Compilers need not take string literals this long; those the project is built with do.
set(text "// Made by src/report/page/embed.cmake.\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n#include \"report/page_parts.hpp\"\n\nnamespace obrys::report {\n")
foreach(part IN LISTS PARTS)
  get_filename_component(name ${part} NAME)
  string(REPLACE . _ name ${name})
  file(READ ${part} content)
  string(APPEND text "const std::string_view ${name} = R\"obrys(${content})obrys\";\n")
endforeach()
string(APPEND text "}  // namespace obrys::report\n")
file(WRITE ${OUT} "${text}")
