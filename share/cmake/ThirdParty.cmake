# Every third-party library, as a target named thirdparty::<name>. Packages: share/tools/packages.txt.
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(octomap REQUIRED)
find_package(SUNDIALS 6.4 REQUIRED COMPONENTS cvode nvecserial)
find_package(mrpt-poses REQUIRED)
find_package(mrpt-obs REQUIRED)
find_package(ZLIB REQUIRED)
find_package(CLI11 2.1 REQUIRED)

add_library(thirdparty::cli11 ALIAS CLI11::CLI11)
add_library(thirdparty::eigen ALIAS Eigen3::Eigen)
add_library(thirdparty::fmt ALIAS fmt::fmt)
add_library(thirdparty::json ALIAS nlohmann_json::nlohmann_json)
add_library(thirdparty::zlib ALIAS ZLIB::ZLIB)

add_library(thirdparty_yaml INTERFACE)
target_link_libraries(thirdparty_yaml INTERFACE yaml-cpp)
add_library(thirdparty::yaml ALIAS thirdparty_yaml)

find_path(ASIO_INCLUDE asio.hpp REQUIRED)
add_library(thirdparty_asio INTERFACE)
target_include_directories(thirdparty_asio SYSTEM INTERFACE ${ASIO_INCLUDE})
target_link_libraries(thirdparty_asio INTERFACE Threads::Threads)
# How Asio allocates would depend on whether a file includes it before or after the first standard header: memory taken
# by one file would be given back by another in another way.
target_compile_definitions(thirdparty_asio INTERFACE ASIO_DISABLE_STD_ALIGNED_ALLOC)
add_library(thirdparty::asio ALIAS thirdparty_asio)

add_library(thirdparty_sundials INTERFACE)
target_link_libraries(thirdparty_sundials INTERFACE SUNDIALS::cvode SUNDIALS::nvecserial)
add_library(thirdparty::sundials ALIAS thirdparty_sundials)

add_library(thirdparty_mrpt INTERFACE)
target_link_libraries(thirdparty_mrpt INTERFACE mrpt::poses)
add_library(thirdparty::mrpt ALIAS thirdparty_mrpt)
add_library(thirdparty_mrpt_obs INTERFACE)
target_link_libraries(thirdparty_mrpt_obs INTERFACE mrpt::obs)
add_library(thirdparty::mrpt_obs ALIAS thirdparty_mrpt_obs)

add_library(thirdparty_octomap INTERFACE)
target_include_directories(thirdparty_octomap SYSTEM INTERFACE ${OCTOMAP_INCLUDE_DIRS})
target_link_libraries(thirdparty_octomap INTERFACE ${OCTOMAP_LIBRARIES})
add_library(thirdparty::octomap ALIAS thirdparty_octomap)

# Debian's component packages of OpenCV carry no CMake configuration; only the GUI-laden meta-package does.
add_library(thirdparty_opencv INTERFACE)
target_include_directories(thirdparty_opencv SYSTEM INTERFACE /usr/include/opencv4)
foreach(module core imgproc imgcodecs)
  find_library(OPENCV_${module} opencv_${module} REQUIRED)
  target_link_libraries(thirdparty_opencv INTERFACE ${OPENCV_${module}})
endforeach()
add_library(thirdparty::opencv ALIAS thirdparty_opencv)

# Libraries of a header and an archive, without CMake configuration of their own.
function(limpet_thirdparty name header)
  find_path(${name}_INCLUDE ${header} REQUIRED)
  find_library(${name}_LIBRARY ${name} REQUIRED)
  add_library(thirdparty_${name} INTERFACE)
  target_include_directories(thirdparty_${name} SYSTEM INTERFACE ${${name}_INCLUDE})
  target_link_libraries(thirdparty_${name} INTERFACE ${${name}_LIBRARY})
  add_library(thirdparty::${name} ALIAS thirdparty_${name})
endfunction()
limpet_thirdparty(sodium sodium.h)
limpet_thirdparty(uring liburing.h)
limpet_thirdparty(xxhash xxhash.h)

if(BUILD_TESTING)
  find_package(GTest REQUIRED)
endif()
