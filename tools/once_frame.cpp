// The frame of every program, compiled once for all: CLI11 takes longer to compile than a chapter.

#include "lattice/report/frame.hpp"
