# Writes to FOUND what CTest is to run of the GoogleTest PROGRAM: its suites, or, where SINGLY, its tests. TIMEOUT [s] is a
# test's; a suite has a quarter of it more for each further test. What is expected to take longer is begun first. No output says
# that something was skipped: CTest would let it outdo the exit status. `./limpet test` counts what skipped itself.
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests WORKING_DIRECTORY "${FOLDER}" OUTPUT_VARIABLE listed
                RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  file(REMOVE "${PROGRAM}")  # or the next build would take it for done
  message(FATAL_ERROR "${NAME} does not list its tests (${status}):\n${listed}")
endif()

function(tell test filter timeout cost)
  set(name "[==[${NAME}/${test}]==]")  # a suite may be named as one of another program
  file(APPEND "${FOUND}.new" "add_test(${name} \"${PROGRAM}\" [==[--gtest_filter=${filter}]==])\n"
       "set_tests_properties(${name} PROPERTIES WORKING_DIRECTORY \"${FOLDER}\" LABELS ${NAME} TIMEOUT ${timeout} "
       "COST ${cost})\n")
endfunction()

function(tell_suite suite tests)
  if(suite STREQUAL "" OR tests EQUAL 0 OR SINGLY)
    return()
  endif()
  math(EXPR timeout "${TIMEOUT} + ${TIMEOUT} * (${tests} - 1) / 4")
  tell("${suite}" "${suite}.*" ${timeout} ${tests})
endfunction()

file(WRITE "${FOUND}.new" "")
string(REGEX REPLACE " *#[^\n]*" "" listed "${listed}")  # parameters: brackets and semicolons mean something to a list
string(REPLACE "\n" ";" lines "${listed}")
set(suite "")
set(tests 0)
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+)\\.$")
    tell_suite("${suite}" ${tests})
    set(suite "${CMAKE_MATCH_1}")
    set(tests 0)
  elseif(line MATCHES "^  ([^ ]+)$")
    math(EXPR tests "${tests} + 1")
    if(SINGLY)
      tell("${suite}.${CMAKE_MATCH_1}" "${suite}.${CMAKE_MATCH_1}" ${TIMEOUT} 1000)
    endif()
  endif()
endforeach()
tell_suite("${suite}" ${tests})
file(RENAME "${FOUND}.new" "${FOUND}")
