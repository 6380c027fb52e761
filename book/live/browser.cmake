# How to compile for the browser: clang and the C++ library for WebAssembly, as Debian packages them.
execute_process(COMMAND clang++ --target=wasm32-wasi --rtlib=compiler-rt -print-libgcc-file-name
                OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
find_program(BROWSER_LINKER wasm-ld)
set(BROWSER_LIBRARIES /usr/lib/wasm32-wasi)
if(NOT EXISTS "${runtime}" OR NOT BROWSER_LINKER OR NOT EXISTS ${BROWSER_LIBRARIES}/libc++.a)
  message(FATAL_ERROR "PAGES: the live ones are left out, clang for the browser is not installed (tools/apt-packages.txt, [live])")
endif()
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_SYSTEM_PREFIX_PATH /usr)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
# Clang 19 crashes while it threads jumps, so that pass is left out.
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fexceptions -fno-rtti -mllvm -jump-threading-threshold=0")
set(CMAKE_CXX_FLAGS_RELEASE -O2 CACHE STRING "Options of the compiler in a release")
# The linker is called by itself: the driver may run an optimiser that breaks vector instructions. It takes the library
# whole, because GNU's ar makes no index of what is compiled for the browser, and then leaves out what nobody calls.
set(CMAKE_CXX_LINK_EXECUTABLE
    "${BROWSER_LINKER} --stack-first -z stack-size=262144 --no-entry --strip-all --gc-sections --export=__wasm_call_ctors -L${BROWSER_LIBRARIES} <OBJECTS> --whole-archive <LINK_LIBRARIES> --no-whole-archive -lc++ -lc++abi -lc ${runtime} -o <TARGET>")
