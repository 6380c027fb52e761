// Nothing of its own: it gives the programs their precompiled headers (see CMakeLists.txt).
