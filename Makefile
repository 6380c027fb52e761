# The lineage: programs -> tables -> figures -> report. `make help` lists what there is.
#
#   LAUNCH=...   put before every simulation, for example  LAUNCH='srun -n1 -c4'
#   THREADS=...  threads of each simulation. Without it a simulation has all cores that this shell
#                may use, with -jN an Nth of them; srun grants the cores of its task itself.
#   QUICK=1      coarse parameters; tables and figures go to build/quick
#   DEPS=skip    do not install missing packages
#   PYTHON=...   a python3 that has matplotlib

SHELL := /bin/sh
.DELETE_ON_ERROR:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules --no-print-directory --silent

B := build
# QUICK=0 and QUICK=no mean what they say.
quick := $(filter-out 0 no off false,$(QUICK))
D := $(B)$(if $(quick),/quick)
LAUNCH ?=
install = DEPS=$(DEPS) sh tools/install-deps.sh tools/apt-packages.txt
CTEST_ARGS := --test-dir $(B) --no-tests=error --output-on-failure --timeout 900
# The first python that has such modules, and python3 where none has; PYTHON=... is taken at its word.
with = $(or $(shell for p in $(if $(named),"$(PYTHON)") python3 /usr/bin/python3; do \
         "$$p" -c 'import $(1)' 2>/dev/null && { echo "$$p"; break; }; done),python3)
named := $(PYTHON)
ifndef named
PYTHON = $(eval PYTHON := $(call with,matplotlib))$(PYTHON)
endif
lineage = "$(PYTHON)" -m lineage
sphinx = "$(call with,sphinx; import myst_parser; import furo)"

# nproc counts the cores that this shell may use; Slurm may have granted the task fewer.
CORES := $(shell n=$$(nproc 2>/dev/null || echo 2); s=$${SLURM_CPUS_PER_TASK:-$$n}; \
           [ "$$s" -lt "$$n" ] 2>/dev/null && echo "$$s" || echo "$$n")
JOBS ?= $(CORES)
# Simulations that run at the same time share the cores. Results do not depend on threads. Two side by side leave no
# core without work where one of them waits for its slowest part; a scheduler that LAUNCH names places them itself.
# A drawing uses one core.
at_once = $(if $(filter -j%,$(MAKEFLAGS)),$(or $(patsubst -j%,%,$(filter -j%,$(MAKEFLAGS))),$(CORES)),1)
share = $(shell n=$$(($(CORES) / $(at_once))); [ $$n -ge 1 ] && echo $$n || echo 1)
threads = $(if $(THREADS),--threads $(THREADS),$(if $(findstring srun,$(LAUNCH)),,--threads $(share)))
two_by_two = $(if $(filter -j%,$(MAKEFLAGS))$(LAUNCH)$(filter 1,$(CORES)),,-j2)
side_by_side = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))

# No `cd` goes elsewhere than it says, and Python finds our modules also where it does not look here by itself.
unexport CDPATH
ifeq ($(MAKELEVEL),0)
export PYTHONPATH := tools$(if $(PYTHONPATH),:$(PYTHONPATH))
endif
# Equal inputs give equal bytes: no dates in figures, one locale everywhere.
export SOURCE_DATE_EPOCH := 1370000000
export LC_ALL := C.UTF-8
export MATPLOTLIBRC := figures
export MPLBACKEND := Agg
export PYTHONDONTWRITEBYTECODE := 1
export LATTICE_REVISION := $(shell sh tools/revision.sh)

# The article is one volume, the folder beyond/ is the second one. The list figures.ecsv of each says which program and
# which script make each figure; ours have an x before their number. `volume=beyond` is for calls from below.
volume := .
home := $(if $(filter beyond,$(volume)),beyond/)
rows_of = $(shell [ ! -f $(1)figures/figures.ecsv ] || awk -F, '!/^\#/ && $$1 != "id" { gsub(" ", ":", $$6); \
            print $$1 "|" $$4 "|$(1)figures/" $$5 "|" $$6 }' $(1)figures/figures.ecsv)
all_rows := $(call rows_of) $(call rows_of,beyond/)
rows := $(call rows_of,$(home))
judge = $(B)/bin/verdicts$(if $(home),_beyond) --root ./$(home) --data $(D)/data --output $(D)/report/claims$(if $(home),_beyond).ecsv
field = $(word $(2),$(subst |, ,$(1)))
tables = $(foreach t,$(subst :, ,$(2)),$(D)/data/$(1)/$(t).ecsv)
drawn = $(D)/figures/$(basename $(notdir $(1)))
command = $(if $(filter x%,$(1)),$(1),fig$(1))
ids := $(foreach r,$(all_rows),$(call field,$(r),1))
svgs := $(foreach r,$(rows),$(call drawn,$(call field,$(r),3)).svg)
images := $(svgs) $(svgs:.svg=.pdf) $(svgs:.svg=.png)
# The dearest program begins first, and no core waits for it at the end. A new one, of unknown cost, is before them.
by_cost := $(shell grep -v '^\#' $(home)paper/costs.ecsv | LC_ALL=C sort -t, -k2gr | cut -d, -f1)
chapters := $(basename $(notdir $(wildcard $(home)src/sec*.cpp)))
chapters := $(filter-out $(by_cost),$(chapters)) $(filter $(chapters),$(by_cost))
runs := $(foreach p,$(chapters),$(D)/data/$(p)/SHA256SUMS)
# What the statements of volume two read of the article's chapters is computed with it.
borrowed := $(if $(home),$(sort $(filter $(basename $(notdir $(wildcard src/sec*.cpp))),$(shell grep -oh '"sec[A-Za-z0-9_]*"' beyond/src/statements/*.cpp 2>/dev/null | tr -d '"'))))
runs += $(foreach p,$(borrowed),$(D)/data/$(p)/SHA256SUMS)

# A reader who has read enough, `make show | head -1`, is no error.
or_read := || { code=$$?; [ $$code = 141 ] || exit $$code; }

# Folders have the names of some of them.
.PHONY: all figures chapter test beyond test-beyond ready all-figures all-data programs configure summary verdicts book weave \
  test-book install-browse test-lineage tests examples python run-tests run-tests-beyond test-python bench paper typeset \
  accept refresh show verify second mutants fresh dist style tidy install-deps burn help
took = printf "together   : %d s with compiling and drawing\n" $$(($$(date +%s) - $$(cat $(D)/report/start)))

## figures: compute and draw the article, then compare with it
figures:
	@sh tools/plan.sh $(B) $(D) $(JOBS) $(home)paper/costs.ecsv $(svgs) -- $(chapters)
	@$(MAKE) ready
	@$(MAKE) all-figures
	@$(MAKE) summary
	@$(took)

## test: compute the data and figures of the article, then test; T=floquet: one file or folder of tests/, T=code: all that compares with no record
T :=
test: $(if $(T),configure,ready)
	@$(if $(T),,$(MAKE) all-figures)
	@$(if $(T),,$(MAKE) run-tests)
	@$(if $(filter lineage,$(T)),$(MAKE) test-lineage)
	@$(if $(filter-out lineage,$(T)),sh tools/test.sh $(B) $(JOBS) $(filter-out lineage,$(T)))

## beyond: the same for volume two, beyond the article: compute, draw, compare
beyond: ready
	@$(MAKE) volume=beyond all-figures
	@$(MAKE) volume=beyond summary
	@$(took)

## test-beyond: the tests of volume two
test-beyond: ready
	@$(MAKE) volume=beyond all-figures
	@$(MAKE) run-tests-beyond

## all: figures, test, beyond and test-beyond
all:
	@$(MAKE) figures
	@$(MAKE) test
	@$(MAKE) beyond
	@$(MAKE) test-beyond

# What must be there, and be right, before hours are spent on computing.
ready: install-deps
	@missing=; sh tools/configure.sh $(B) || missing=yes; PYTHON="$(PYTHON)" sh tools/draw.sh && [ -z "$$missing" ]
	@mkdir -p $(D)/report && date +%s > $(D)/report/start
	@$(lineage) tables --data $(D)/data

all-figures: programs
	@$(MAKE) built=yes $(two_by_two) all-data
	@$(MAKE) built=yes $(side_by_side) $(images)
all-data: $(runs)

## programs: build build/bin/<program>
# A single figure needs only its own program. Who calls with `built=yes` has just built them.
TARGETS := programs$(if $(home),_beyond $(borrowed))
built :=
programs: $(if $(built),,configure)
	@$(if $(built),,sh tools/build.sh $(B) $(JOBS) $(TARGETS))

configure:
	@sh tools/configure.sh $(B)

# compute.sh decides whether a program is another one than that which wrote the tables.
$(sort $(runs) $(foreach r,$(all_rows),$(D)/data/$(call field,$(r),2)/SHA256SUMS)): $(D)/data/%/SHA256SUMS: programs
	@sh tools/compute.sh $(B)/bin/$* $@ $(D)/report/cost/$* $(at_once) \
	  $(LAUNCH) $(B)/bin/$* --out $(@D) $(if $(quick),--quick) $(threads)

# $(1) id, $(2) program, $(3) script, $(4) tables. Tables come with their list, which is written last.
define figure
.PHONY: $(call command,$(1))
$(call command,$(1)): ready
	@$$(MAKE) TARGETS=$(2) $(foreach e,svg pdf png,$(call drawn,$(3)).$(e))
	@echo "  figure   $(call drawn,$(3)).png"
$(call drawn,$(3)).svg: $(3) $(D)/data/$(2)/SHA256SUMS $(call tables,$(2),$(4)) tools/draw.sh \
    $(if $(filter %.gp,$(3)),figures/style.gp,figures/draw.py figures/matplotlibrc)
	@mkdir -p $$(@D)
	@echo "  draw     $(basename $(notdir $(3)))"
	@PYTHON="$$(PYTHON)" FROM="$$^" sh tools/draw.sh $$@ $(D)/data $$<
$(call tables,$(2),$(4)): $(D)/data/$(2)/SHA256SUMS
endef
$(foreach r,$(all_rows),$(eval $(call figure,$(call field,$(r),1),$(call field,$(r),2),$(call field,$(r),3),$(call field,$(r),4))))
$(sort $(foreach r,$(all_rows),$(call tables,$(call field,$(r),2),$(call field,$(r),4)))): ;

# fig7 is fig07, x1 is x01.
.PHONY: $(patsubst 0%,fig%,$(filter 0%,$(ids))) $(patsubst x0%,x%,$(filter x0%,$(ids)))
$(foreach i,$(patsubst 0%,%,$(filter 0%,$(ids))),$(eval fig$(i): fig0$(i)))
$(foreach i,$(patsubst x0%,%,$(filter x0%,$(ids))),$(eval x$(i): x0$(i)))

%.pdf: %.svg
	@FROM="$<" sh tools/draw.sh $@ $<
%.png: %.svg
	@FROM="$<" sh tools/draw.sh $@ $<

summary:
	@echo
	@echo "figures    : $(words $(wildcard $(svgs))) in $(D)/figures (svg, pdf, png)"
	@$(lineage) tables --data $(D)/data
	@$(judge)
	@cd $(D)/report/cost && cat $(chapters) | awk '{ s += $$1 } END { printf "computing  : %.0f s in %d programs\n", s, NR }'
	@$(if $(home),,echo "report     : $(D)/report/claims.ecsv, make show ID=...")

# Judges what there is; before anything is computed, verdicts are those that are recorded.
verdicts:
	@[ ! -x $(firstword $(judge)) ] || [ ! -d $(D)/data ] || $(judge) > /dev/null

## book: build the book from sources, data and figures into build/book
book: install-deps
	@$(install) book
	@! apt-cache show libc++-dev-wasm32 >/dev/null 2>&1 || $(install) live || true
	@$(MAKE) all-figures
	@$(MAKE) weave

## weave: build the book from the existing data and figures, in seconds
weave: verdicts
	@if sh tools/configure.sh $(B)/live book/live; then sh tools/build.sh $(B)/live $(JOBS) pages; else rm -f $(B)/live/*.wasm; fi
	@[ ! -f $(D)/data/sec5_experiment/SHA256SUMS ] || $(MAKE) volume=beyond verdicts
	@rm -rf $(D)/book.part $(D)/book.pages $(D)/book.read && mkdir -p $(D)/book.pages
	@$(sphinx) -m sphinx -q -n -W --keep-going -D literate_build=$(D) -c book -d $(D)/book.read $(D)/book.pages $(D)/book.part
	@rm -rf $(D)/book $(D)/book.read && mv $(D)/book.part $(D)/book
	@set -- $(D)/book/*.html && echo "book       : $$# pages, $(D)/book/index.html"

## test-book: the tests of lineage and book, and every page of the book in a headless Chromium
test-book: test-lineage install-browse
	@test ! -f $(D)/book/index.html || "$(call with,selenium)" book/browse.py $(D)/book
install-browse:
	@$(install) browse
test-lineage:
	@$(sphinx) tests/lineage

# Folders that have the name of something that can be made.
tests: test
## examples: build the programs of examples/ against the installed library and run them
examples: configure
	@sh tools/build.sh $(B) $(JOBS) lattice report
	@ctest -R '^programs/install$$' $(CTEST_ARGS)

## chapter: compute, draw and judge a chapter of one's own, a copy C=... of examples/chapter
C := examples/chapter
chapter: configure
	@sh tools/build.sh $(B) $(JOBS) report $(shell grep -qs lattice::lattice "$(C)/CMakeLists.txt" && echo lattice)
	@cmake -S "$(C)" -B "$(C)/build" -D CMAKE_PREFIX_PATH="$(abspath $(B))" -D CMAKE_BUILD_TYPE=Release > /dev/null
	@cmake --build "$(C)/build"

## python: build the Python module, build/python/lattice
python: configure
	@sh tools/build.sh $(B) $(JOBS) python_$(if $(home),beyond,module)

run-tests: configure
	@sh tools/build.sh $(B) $(JOBS) all
	@$(MAKE) QUICK=1 built=yes $(two_by_two) all-data
	@$(MAKE) verdicts
	@$(MAKE) test-lineage > $(B)/lineage.log 2>&1 & lineage=$$!; \
	ctest -j $(JOBS) $(CTEST_ARGS) --label-exclude beyond; good=$$?; \
	wait $$lineage || good=1; cat $(B)/lineage.log; exit $$good
run-tests-beyond: configure
	@sh tools/build.sh $(B) $(JOBS) programs programs_beyond tests_beyond python_beyond
	@$(MAKE) volume=beyond QUICK=1 built=yes $(two_by_two) all-data
	@$(MAKE) volume=beyond verdicts
	@$(sphinx) tests/lineage beyond
	@ctest -j $(JOBS) $(CTEST_ARGS) --label-regex beyond

## test-python: test the Python module, built with sanitizers (long)
test-python: export ASAN_OPTIONS := detect_leaks=0:verify_asan_link_order=0
test-python: programs
	@sh tools/configure.sh $(B)/asan . -DCMAKE_BUILD_TYPE=Debug \
	  '-DCMAKE_CXX_FLAGS_DEBUG=-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all'
	@sh tools/build.sh $(B)/asan $(JOBS) python_module
	@PYTHONPATH=$(B)/asan/python:python \
	  LD_PRELOAD="$$(c++ -print-file-name=libasan.so) $$(c++ -print-file-name=libstdc++.so)" \
	  "$(call with,numpy)" python/tests.py $(B)/bin

## bench: time the integrators against GSL and Boost.odeint (a minute) into build/ratios.ecsv
bench: ready
	@sh tools/build.sh $(B) $(JOBS) bench
	@$(B)/bin/bench_ratios $(B)/ratios.ecsv

## paper: typeset build/paper.pdf, and theorem.pdf of volume two, from the reference values and the figures
paper: install-deps
	@$(install) paper
	@$(MAKE) all-figures
	@$(MAKE) typeset

## typeset: the same from the figures that are there, in seconds
typeset: verdicts
	@$(lineage) macros --out $(D)/paper
	@for it in paper/paper $(basename $(wildcard beyond/paper/theorem.tex)); do \
	  name=$${it##*/}; echo "  typeset  $(D)/$$name.pdf"; \
	  TEXINPUTS="$(D)/paper:paper:beyond/paper:$(D)/figures:" BIBINPUTS="paper:" FORCE_SOURCE_DATE=1 \
	    latexmk -norc -g -pdf -interaction=nonstopmode -halt-on-error -outdir=$(D)/paper $$it.tex \
	    > $(D)/paper/$$name.out.log 2>&1 || { tail -n 40 $(D)/paper/$$name.out.log; exit 1; }; \
	  mv $(D)/paper/$$name.pdf $(D)/$$name.pdf.part && mv $(D)/$$name.pdf.part $(D)/$$name.pdf || exit; done

## accept: record what is computed now, values, bytes and the numbers in prose, and print what moved (volume=beyond: of volume two)
accept: ready
	@$(MAKE) QUICK= programs
	@$(MAKE) QUICK= built=yes $(two_by_two) all-data
	@$(MAKE) QUICK= verdicts
	@$(lineage) --root ./$(home) accept --data $(B)/data
	@$(MAKE) QUICK= refresh

## refresh: write the recorded values into the prose of src/, and renew the tables of README.md
refresh: verdicts
	@$(lineage) refresh --costs $(B)/report/cost
	@[ ! -d beyond ] || $(lineage) --root beyond refresh --costs $(B)/report/cost

## show: print one statement, finding or number with all that decides it, as in  make show ID=pn.omega11
show: verdicts
	@$(lineage) show "$(ID)" --data $(B)/data $(or_read)

## verify: run the one program that decides a statement and judge, as in  make verify ID=pn.omega11
verify: ready
	@f=$$(grep -lF 'STATEMENT("$(ID)")' $(wildcard src/statements/*.cpp beyond/src/statements/*.cpp)); \
	[ -n "$$f" ] || { echo "make: ID=$(ID): no statement has this name (allowed: an id of a statement or a finding)" >&2; exit 2; }; \
	p=$$(basename "$$f" .cpp); case $$f in beyond*) v=beyond j=verdicts_beyond;; *) v=. j=verdicts;; esac; \
	rm -f $(B)/data/$$p/SHA256SUMS; $(MAKE) QUICK= volume=$$v TARGETS="$$p $$j" $(B)/data/$$p/SHA256SUMS && \
	  $(MAKE) QUICK= volume=$$v verdicts && $(lineage) show "$(ID)" --data $(B)/data $(or_read)

## second: recompute the headline numbers by other methods in plain Python, into paper/second.ecsv of each volume (minutes)
second: install-deps
	@PYTHONPATH=tests:$(PYTHONPATH) "$(call with,numpy; import mpmath)" -m second --write

## mutants: put errors into the sources one at a time and check that the tests fail (long)
mutants:
	@"$(PYTHON)" tools/mutants.py $(MUTANTS)

## fresh: run the README's commands, make beyond, test-beyond, book and paper in a bare Debian root (SUITE=trixie; needs root)
fresh:
	@sh tools/fresh.sh $(SUITE)

## dist: pack sources, tables, figures, and those of book, paper and theorem that exist, into one archive, build/dist
dist:
	@sh tools/dist.sh $(B)

## style: run clang-format, shellcheck and reuse (version 4 or newer), where installed
style:
	@! command -v clang-format >/dev/null 2>&1 || { files=$$(git ls-files '*.[chi]pp') && clang-format --dry-run --Werror $${files:?git lists none}; }
	@! command -v shellcheck >/dev/null 2>&1 || shellcheck .ci/run tools/*.sh tests/*/*.sh examples/*.sbatch $(wildcard beyond/examples/*.sbatch)
	@! reuse --version 2>/dev/null | grep -Eq ' ([4-9]|[1-9][0-9])\.' || reuse lint --lines

## tidy: run clang-tidy on the sources changed since a commit, SINCE=HEAD~1; without SINCE on all (an hour)
tidy:
	@sh tools/tidy.sh $(SINCE)

## install-deps: install the Debian packages of tools/apt-packages.txt that are missing
install-deps:
	@$(install)

## burn: remove everything that was built or computed
burn:
	@rm -rf $(B)

## help: print this list
help:
	@(sed -n 's/^## /  make /p' Makefile; \
	awk '!/^#/ { at = index($$0, ","); id = substr($$0, 1, at - 1); if (id == "id") next; \
	  text = $$0; for (k = 0; k < 6; ++k) text = substr(text, index(text, ",") + 1); \
	  split(text, quoted, "\""); printf "  make %s: %s\n", (id ~ /^x/ ? id : "fig" id), quoted[2] }' $(wildcard figures/figures.ecsv beyond/figures/figures.ecsv); \
	echo "Variables: DEPS=skip (install nothing), PYTHON=..., JOBS=..., LAUNCH=... (put before each simulation),"; \
	echo "  THREADS=... (of each program), QUICK=1 (coarse, into $(B)/quick)") $(or_read)

# What has no rule is mistyped.
.DEFAULT:
	$(error '$@': unknown target or file (allowed: those that `make help` lists))
