# What `cmake --install` puts where: programs in bin; missions, plugs, vehicles, networks and the template of a user's own
# repository in share/limpet, laid out as here; headers and archives of what own apps and behaviors are made of, with
# `find_package(Limpet)`: targets Limpet::app and Limpet::helm, function limpet_add_behavior.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(LIMPET_DATA "${CMAKE_INSTALL_DATADIR}/limpet")
set(LIMPET_CONFIG "${CMAKE_INSTALL_LIBDIR}/cmake/Limpet")
get_property(processes GLOBAL PROPERTY LIMPET_PROCESSES)
install(TARGETS limpet ${processes} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT limpet)
install(DIRECTORY missions plugs DESTINATION "${LIMPET_DATA}" COMPONENT limpet PATTERN runs EXCLUDE)
install(DIRECTORY share/vehicles share/networks share/detectors DESTINATION "${LIMPET_DATA}/share" COMPONENT limpet)
install(DIRECTORY share/limpet-template DESTINATION "${LIMPET_DATA}/share" COMPONENT limpet)

# What Limpet::app and Limpet::helm stand on.
set(LIMPET_INSTALLED core durable simulation wire shapes waypoints objects packing topics decision mission pubsub app survey planning
                     helm)
foreach(library ${LIMPET_INSTALLED})
  target_include_directories(limpet_${library} PUBLIC "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  install(DIRECTORY share/limpet/${library} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/limpet" COMPONENT limpet-dev
          FILES_MATCHING PATTERN "*.hpp")
endforeach()
list(TRANSFORM LIMPET_INSTALLED PREPEND limpet_ OUTPUT_VARIABLE archives)
install(TARGETS ${archives} thirdparty_asio thirdparty_uring thirdparty_xml thirdparty_yaml EXPORT LimpetTargets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}/limpet" COMPONENT limpet-dev)
install(EXPORT LimpetTargets NAMESPACE Limpet:: DESTINATION "${LIMPET_CONFIG}" COMPONENT limpet-dev)
configure_package_config_file(share/cmake/LimpetConfig.cmake.in LimpetConfig.cmake INSTALL_DESTINATION "${LIMPET_CONFIG}"
                              PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(LimpetConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/LimpetConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/LimpetConfigVersion.cmake"
              share/cmake/behavior_module.cpp
        DESTINATION "${LIMPET_CONFIG}" COMPONENT limpet-dev)

# Behaviors from shared objects find all of this in the program that loads them. One flag for all: the feature
# WHOLE_ARCHIVE would take archives twice that stand on the command line twice.
list(TRANSFORM archives REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE files)
string(JOIN "," whole ${files})
foreach(host limpet pHelm)
  target_link_options(${host} PRIVATE "-Wl,--whole-archive,${whole},--no-whole-archive")
  add_dependencies(${host} ${archives})
  set_target_properties(${host} PROPERTIES ENABLE_EXPORTS ON)
endforeach()
