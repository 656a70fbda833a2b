# Debian packages: `limpet` has programs, missions and manual pages, `limpet-dev` what own apps and behaviors are built
# against. `cmake --build build --target packages` writes them to build/packages. Needs dpkg-dev; manual pages need
# help2man, and a package without them is told apart by a message of this file.
set(LIMPET_PACKAGE_CONTACT "The Limpet authors <limpet@example.org>" CACHE STRING "Maintainer of the Debian packages")
set(documents "${CMAKE_CURRENT_BINARY_DIR}/package")

# What a program does, as its README begins: up to the first stop.
function(limpet_summary program result)
  set(summary "surveys the seabed and says what has changed")
  if(EXISTS "${CMAKE_SOURCE_DIR}/apps/${program}/README.md")
    file(STRINGS "${CMAKE_SOURCE_DIR}/apps/${program}/README.md" lines)
    list(FILTER lines EXCLUDE REGEX "^#|^$")
    list(GET lines 0 first)
    string(REGEX MATCH "^[^:;.,(]+" summary "${first}")
    string(REGEX REPLACE "[`*]" "" summary "${summary}")
    string(STRIP "${summary}" summary)
  endif()
  set(${result} "${summary}" PARENT_SCOPE)
endfunction()

# Manual pages are what programs say of themselves.
find_program(LIMPET_HELP2MAN help2man)
find_program(LIMPET_GZIP gzip)
if(LIMPET_HELP2MAN AND LIMPET_GZIP)
  set(pages)
  # The page of `program`, which says its help when `command` is asked for it.
  function(limpet_manual_page page_name program command summary)
    set(page "${documents}/man1/${page_name}.1")
    add_custom_command(
      OUTPUT "${page}.gz"
      COMMAND "${CMAKE_COMMAND}" -E make_directory "${documents}/man1"
      COMMAND "${LIMPET_HELP2MAN}" --no-info --section=1 --source=Limpet --manual=Limpet
              "--version-string=${PROJECT_VERSION}" "--name=${summary}" "--output=${page}" "${command}"
      COMMAND "${LIMPET_GZIP}" -9nf "${page}"
      DEPENDS ${program}
      VERBATIM)
    set(pages ${pages} "${page}.gz" PARENT_SCOPE)
  endfunction()
  foreach(program limpet ${processes})
    limpet_summary(${program} summary)
    limpet_manual_page(${program} ${program} "$<TARGET_FILE:${program}>" "${summary}")
  endforeach()
  # And one of each verb, limpet-<verb>: a program of that name, for help2man alone, says the verb's help.
  set(verbs "${CMAKE_SOURCE_DIR}/apps/limpet/verbs/verbs.cpp")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${verbs}")
  file(STRINGS "${verbs}" lines REGEX "^ +{\"[a-z]+\", \"")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "{\"([a-z]+)\", \"(.*)\", Run" ignored "${line}")
    set(verb "${CMAKE_MATCH_1}")
    set(command "${documents}/verbs/limpet-${verb}")
    file(GENERATE OUTPUT "${command}" CONTENT "#!/bin/sh\nexec \"$<TARGET_FILE:limpet>\" ${verb} \"$@\"\n"
         FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
    limpet_manual_page(limpet-${verb} limpet "${command}" "${CMAKE_MATCH_2}")
  endforeach()
  add_custom_target(man_pages DEPENDS ${pages})
else()
  message(STATUS "help2man or gzip is missing: packages get no manual pages")
  add_custom_target(man_pages)
endif()
install(DIRECTORY "${documents}/man1" DESTINATION "${CMAKE_INSTALL_MANDIR}" COMPONENT limpet OPTIONAL)

# What a Debian package says of its origin.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${documents}/changelog"
     "limpet (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See CHANGELOG.md of this version.\n\n"
     " -- ${LIMPET_PACKAGE_CONTACT}  ${date}\n")
if(LIMPET_GZIP)
  execute_process(COMMAND "${LIMPET_GZIP}" -9nfk "${documents}/changelog" COMMAND_ERROR_IS_FATAL ANY)
endif()
foreach(package limpet limpet-dev)
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" RENAME copyright COMPONENT ${package})
  install(FILES "${documents}/changelog.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${package}
          OPTIONAL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL limpet limpet-dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_NAME limpet)
set(CPACK_PACKAGE_CONTACT "${LIMPET_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/packages")
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# Files of a package are the same for everybody, whatever umask it was built with.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_LIMPET_PACKAGE_NAME limpet)
set(CPACK_DEBIAN_LIMPET_PACKAGE_SECTION science)
set(CPACK_DEBIAN_LIMPET_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_LIMPET_DESCRIPTION
    "autonomy of underwater vehicles that survey the seabed
Covers an area, keeps a map and the objects in it, looks again at what is in
doubt, goes home, and says what has changed since the last time. Runs missions
and speaks to programs of MOOS; simulates vehicles, sensors and a camera.")
set(CPACK_DEBIAN_LIMPET-DEV_PACKAGE_NAME limpet-dev)
set(CPACK_DEBIAN_LIMPET-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIMPET-DEV_PACKAGE_DEPENDS
    "limpet (= ${PROJECT_VERSION}), libasio-dev, libeigen3-dev, libfmt-dev, liburing-dev, libyaml-cpp-dev, libpugixml-dev, nlohmann-json3-dev, zlib1g-dev"
)
set(CPACK_DEBIAN_LIMPET-DEV_PACKAGE_RECOMMENDS libgtest-dev)
set(CPACK_COMPONENT_LIMPET-DEV_DESCRIPTION
    "headers and archives for apps and behaviors of Limpet
What a repository of your own is built against that adds apps or behaviors to
a Limpet that is installed: CMake finds it as Limpet.")
include(CPack)
add_custom_target(
  packages
  COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB --config "${CMAKE_CURRENT_BINARY_DIR}/CPackConfig.cmake"
  DEPENDS programs man_pages ${archives}
  VERBATIM USES_TERMINAL)
