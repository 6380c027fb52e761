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
MAKEFLAGS += --no-builtin-rules --no-print-directory

B := build
.PRECIOUS: $(B)/bin/%
# QUICK=0 and QUICK=no mean what they say.
quick := $(filter-out 0 no off false,$(QUICK))
D := $(B)$(if $(quick),/quick)
LAUNCH ?=
CTEST_ARGS := --output-on-failure --timeout 900
# PYTHON=... on the command line is taken at its word; one that the shell exports is only tried first.
ifneq ($(origin PYTHON),command line)
pythons := $(PYTHON)
PYTHON = $(eval PYTHON := $(shell for p in $(pythons) python3 /usr/bin/python3; do \
           $$p -c 'import matplotlib' 2>/dev/null && { echo $$p; break; }; done))$(PYTHON)
endif
# nproc counts the cores that this shell may use; Slurm may have granted the task fewer.
CORES := $(shell n=$$(nproc 2>/dev/null || echo 2); s=$${SLURM_CPUS_PER_TASK:-$$n}; \
           [ "$$s" -lt "$$n" ] 2>/dev/null && echo "$$s" || echo "$$n")
JOBS ?= $(CORES)
# Simulations that run at the same time share the cores. Results do not depend on threads.
at_once = $(if $(filter -j%,$(MAKEFLAGS)),$(or $(patsubst -j%,%,$(filter -j%,$(MAKEFLAGS))),$(CORES)),1)
share = $(shell n=$$(($(CORES) / $(at_once))); [ $$n -ge 1 ] && echo $$n || echo 1)
threads = $(if $(THREADS),--threads $(THREADS),$(if $(findstring srun,$(LAUNCH)),,--threads $(share)))

# Equal inputs give equal bytes: no dates in figures, one locale everywhere.
export SOURCE_DATE_EPOCH := 1370000000
export LC_ALL := C.UTF-8
export MATPLOTLIBRC := figures
export MPLBACKEND := Agg
export PYTHONDONTWRITEBYTECODE := 1
export LATTICE_REVISION := $(shell git describe --always --dirty --abbrev=12 2>/dev/null)

# figures/figures.ecsv says which program and which script make each figure.
rows := $(shell awk -F, '!/^\#/ && $$1 != "id" { gsub(" ", ":", $$7); print $$1 "|" $$4 "|" $$5 "|" $$7 }' figures/figures.ecsv)
field = $(word $(2),$(subst |, ,$(1)))
tables = $(foreach t,$(subst :, ,$(2)),$(D)/data/$(1)/$(t).ecsv)
ids := $(foreach r,$(rows),$(call field,$(r),1))
chapters := $(basename $(notdir $(wildcard src/sec*.cpp)))
results := $(foreach p,$(chapters),$(D)/data/$(p)/results.ecsv)
svgs := $(foreach r,$(rows),$(D)/figures/$(basename $(call field,$(r),3)).svg)
images := $(svgs) $(svgs:.svg=.pdf) $(svgs:.svg=.png)

.PHONY: figures test all-figures all-data programs install-deps burn help readme refresh lock summary
.PHONY: $(foreach i,$(ids),$(if $(filter x%,$(i)),$(i),fig$(i)))

# A drawing uses one core. Two programs side by side leave no core without work where one of them waits for its
# slowest part; a scheduler that LAUNCH names places them itself.
side_by_side = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))
two_by_two = $(if $(filter -j%,$(MAKEFLAGS))$(LAUNCH)$(filter 1,$(CORES)),,-j2)

## figures: compute and draw everything, then compare with the article
figures: install-deps
	@sh tools/need-tools.sh "$(PYTHON)"
	@sh tools/configure.sh $(B)
	@mkdir -p $(D)/report && (. tools/shared.sh; now) > $(D)/report/start
	@sh tools/tables.sh $(D)/data
	@$(MAKE) programs
	@$(MAKE) $(two_by_two) all-data
	@$(MAKE) $(side_by_side) all-figures
	@$(MAKE) summary
	@. tools/shared.sh; echo "$$(now) $$(cat $(D)/report/start)" | \
	  awk '{ printf "together   : %.0f s, with compiling and drawing\n", ($$1 > $$2 ? $$1 - $$2 : 0) }'

## test: everything the tests need (data and figures), then the tests
test: install-deps
	@sh tools/need-tools.sh "$(PYTHON)"
	@sh tools/tables.sh $(D)/data
	@$(MAKE) all-figures
	@$(MAKE) run-tests

all-figures: $(images) all-data
all-data: $(results)

## programs: build build/bin/<program>
# A single figure needs only its own program.
TARGETS := programs
programs: configure
	@sh tools/build.sh $(B) $(JOBS) $(TARGETS)

.PHONY: configure
configure:
	@sh tools/configure.sh $(B)

# The build decides whether a program is new; its date alone decides whether it runs again.
$(B)/bin/%: programs
	@test -x $@

$(D)/data/%/results.ecsv: $(B)/bin/%
	@sh tools/compute.sh $< $@ $(D)/report/cost/$* $(at_once) \
	  $(LAUNCH) $< --out $(@D) $(if $(quick),--quick) $(threads)

# $(1) id, $(2) program, $(3) script, $(4) tables
define figure
$(if $(filter x%,$(1)),$(1),fig$(1)): install-deps
	@sh tools/need-tools.sh "$$(PYTHON)"
	@sh tools/tables.sh $(D)/data
	@$$(MAKE) TARGETS=$(2) $(foreach e,svg pdf png,$(D)/figures/$(basename $(3)).$(e))
	@echo "  figure   $(D)/figures/$(basename $(3)).png"
$(D)/figures/$(basename $(3)).svg: figures/$(3) $(D)/data/$(2)/results.ecsv $(call tables,$(2),$(4)) tools/draw.sh \
    $(if $(filter %.gp,$(3)),figures/style.gp,figures/draw.py figures/matplotlibrc)
	@mkdir -p $$(@D)
	@echo "  draw     $(basename $(3))"
	@PYTHON="$$(PYTHON)" FROM="$$^" sh tools/draw.sh $$@ $(D)/data $$<
$(call tables,$(2),$(4)): $(D)/data/$(2)/results.ecsv
endef
need_python = test -n "$(PYTHON)" || { echo "no python3 with matplotlib found (set PYTHON=...)"; exit 1; };
$(foreach r,$(rows),$(eval $(call figure,$(call field,$(r),1),$(call field,$(r),2),$(call field,$(r),3),$(call field,$(r),4))))

# A table comes with the results, which are written last and say that a run is complete.
$(sort $(foreach r,$(rows),$(call tables,$(call field,$(r),2),$(call field,$(r),4)))): ;

# fig7 is fig07, x1 is x01.
.PHONY: $(patsubst 0%,fig%,$(filter 0%,$(ids))) $(patsubst x0%,x%,$(filter x0%,$(ids)))
$(foreach i,$(patsubst 0%,%,$(filter 0%,$(ids))),$(eval fig$(i): fig0$(i)))
$(foreach i,$(patsubst x0%,%,$(filter x0%,$(ids))),$(eval x$(i): x0$(i)))

%.pdf: %.svg
	@FROM="$<" sh tools/draw.sh $@ $<
%.png: %.svg
	@FROM="$<" sh tools/draw.sh $@ $<

# What reads the tables: a python with the standard library, for the book one with these modules too.
lineage = "$(or $(PYTHON),python3)" -m lineage
with = "$(or $(shell for p in "$(PYTHON)" python3 /usr/bin/python3; do \
          "$$p" -c 'import $(1)' 2>/dev/null && { echo "$$p"; break; }; done),python3)"
weaver = $(call with,jinja2; import pygments)

summary:
	@echo
	@echo "figures    : $(words $(svgs)) in $(D)/figures (svg, pdf, png)"
	@$(lineage) summary --data $(D)/data --out $(D)/report
	@echo "computing  : $$(cat $(D)/report/cost/* | awk '{ s += $$1 } END { printf "%.0f", s }') s in $(words $(chapters)) programs"
	@echo "report     : $(D)/report/published.ecsv"

## book: weave the book from sources, data and figures into build/book
.PHONY: book weave install-book test-lineage test-book
book: install-book
	@$(MAKE) all-figures
	@$(MAKE) weave

## weave: the same from the data and figures that are there, in seconds
weave:
	@sh book/live/build.sh $(B)/live
	@$(weaver) -m lineage weave --data $(D)/data --figures $(D)/figures --live $(B)/live --programs $(B)/bin \
	  --out $(D)/book

install-book: install-deps
	@DEPS=$(DEPS) sh tools/install-deps.sh apt-packages.txt book
	@! apt-cache show libc++-dev-wasm32 >/dev/null 2>&1 || \
	  DEPS=$(DEPS) sh tools/install-deps.sh apt-packages.txt live || true

## test-book: the tests of the weaver, and every page of the book in a headless Chromium
test-book: test-lineage
	@DEPS=$(DEPS) sh tools/install-deps.sh apt-packages.txt browse
	@test ! -f $(D)/book/index.html || $(call with,selenium) -m lineage.book.browse $(D)/book
test-lineage:
	@$(weaver) -m lineage.tests

# Folders that have the name of something that can be made.
.PHONY: tests examples src
tests: test
src: programs
## examples: build the programs of examples/ against the installed library and run them
examples: programs
	@cd $(B) && ctest -R '^install$$' $(CTEST_ARGS)

## python: build the Python module, build/python/lattice
.PHONY: python
python: configure
	@sh tools/build.sh $(B) $(JOBS) python_module

.PHONY: run-tests
run-tests: programs
	@sh tools/build.sh $(B) $(JOBS) all
	@$(lineage) summary --data $(B)/data --out $(B)/report > /dev/null
	@$(MAKE) test-lineage
	@cd $(B) && ctest -j $(JOBS) $(CTEST_ARGS)

## test-faults: runs that are killed, out of time or disk, or that nobody reads (minutes)
.PHONY: test-faults test-fuzz
test-faults: programs
	@$(or $(PYTHON),python3) tests/faults.py . $(B)/bin 60
	@sh tests/make.sh . && sh tests/drawing.sh .

## test-fuzz: 5,000 random command lines for programs with sanitizers (SEED=..., COUNT=...; long)
COUNT := 5000
SEED = $(shell date +%s)
test-fuzz: install-deps
	@cmake --preset asan > /dev/null
	@sh tools/build.sh $(B)/asan $(JOBS) programs
	@LATTICE_SLACK=12 $(or $(PYTHON),python3) tests/fuzz.py $(B)/asan/bin $(COUNT) $(SEED)

## bench: time our integrators against GSL and Boost.odeint (ten minutes, not part of the tests)
.PHONY: bench
bench: install-deps configure
	@mkdir -p $(B)/bench
	@cmake --build $(B) --parallel $(JOBS) --target bench > $(B)/bench/build.log 2>&1 || \
	  { cat $(B)/bench/build.log; exit 1; }
	@$(B)/bin/bench_kernels --benchmark_min_time=0.1
	@$(B)/bin/bench_ratios --out $(B)/bench
	@$(need_python) "$(PYTHON)" figures/x04_work_precision.py $(B)/bench $(B)/bench/work_precision.svg
	@$(MAKE) $(B)/bench/work_precision.pdf $(B)/bench/work_precision.png

## ratios: put the ratios of the last `make bench` into bench/ratios.ecsv and README.md
.PHONY: ratios
ratios:
	@cp $(B)/bench/ratios.ecsv bench/ratios.ecsv
	@$(MAKE) refresh

## paper: typeset build/paper.pdf from the locked values and all figures
.PHONY: paper typeset install-paper
paper: install-paper
	@$(MAKE) all-figures
	@$(MAKE) typeset

## typeset: the same from the figures that are there, in seconds
typeset:
	@$(lineage) macros --out $(D)/paper
	@echo "  typeset  $(D)/paper.pdf"
	@TEXINPUTS="paper:$(D)/paper:$(D)/figures:" BIBINPUTS="paper:" FORCE_SOURCE_DATE=1 \
	  latexmk -norc -g -pdf -interaction=nonstopmode -halt-on-error -outdir=$(D)/paper paper/paper.tex \
	  > $(D)/paper/typeset.log 2>&1 || { tail -n 40 $(D)/paper/typeset.log; exit 1; }
	@mv $(D)/paper/paper.pdf $(D)/paper.pdf.part && mv $(D)/paper.pdf.part $(D)/paper.pdf

install-paper: install-deps
	@DEPS=$(DEPS) sh tools/install-deps.sh apt-packages.txt paper

## lock: renew paper/converged.ecsv from the computed values and print what moved
lock: install-deps
	@$(MAKE) all-data
	@$(lineage) lock --data $(B)/data

## hashes: renew paper/hashes.ecsv, the bytes of all tables of the full and the quick run, and print what moved
.PHONY: hashes
hashes: install-deps
	@$(MAKE) QUICK= all-data
	@$(MAKE) QUICK=1 all-data
	@$(lineage) hashes --data $(B)/data --quick $(B)/quick/data

## refresh: write the locked values into the prose of src/, and renew the tables of README.md
refresh readme:
	@$(lineage) refresh --costs $(B)/report/cost

## show: one number, as in  make show ID=pn.omega11
.PHONY: show
show:
	@$(lineage) show "$(ID)" --data $(B)/data

## gallery: renew the small pictures of the README
.PHONY: gallery
gallery: all-figures
	@$(need_python) $(lineage) gallery --figures $(D)/figures

## second: headline numbers again by other methods in plain Python, into paper/second.ecsv (minutes)
.PHONY: second
second: install-deps
	@PYTHONPATH=tests $(call with,numpy; import mpmath) -m second --out paper/second.ecsv

## mutants: errors of physics put into the library one at a time; the tests must notice (long)
.PHONY: mutants
mutants: install-deps
	@$(or $(PYTHON),python3) tools/mutants.py $(MUTANTS)

## test-platforms: the same bytes from other compilers, Debian 13 and ARM64 (an hour; PLATFORMS='clang trixie')
.PHONY: test-platforms test-slurm
test-platforms: install-deps
	@sh tools/platforms.sh $(PLATFORMS)

## test-slurm: the lineage and a map in parts under Slurm, on a cluster of two nodes on this machine (takes root)
test-slurm: programs
	@sh tests/slurm/run.sh

## fresh: the README's commands, make book and make paper in a bare Debian root (SUITE=trixie; takes root)
.PHONY: fresh
fresh:
	@sh tools/fresh.sh $(SUITE)

## container: the steps of the Dockerfile in a bare root, where no container can run (SUITE=trixie; takes root)
.PHONY: container
container:
	@sh tools/fresh.sh --container $(SUITE)

## dist: sources, tables, figures, and the book and the report that are there, in one archive, build/dist
.PHONY: dist
dist:
	@$(lineage) inventory --data $(B)/data --programs $(B)/bin --out $(B)/report
	@sh tools/dist.sh $(B)

## style: clang-format and shellcheck, where they are installed
.PHONY: style
style:
	@! command -v clang-format >/dev/null 2>&1 || git ls-files '*.cpp' '*.hpp' | xargs clang-format --dry-run --Werror
	@! command -v shellcheck >/dev/null 2>&1 || shellcheck .ci/run tools/*.sh tests/*.sh tests/slurm/*.sh examples/*.sbatch

## install-deps: install the Debian packages of apt-packages.txt that are missing
install-deps:
	@DEPS=$(DEPS) sh tools/install-deps.sh apt-packages.txt

## burn: remove all products
burn:
	@rm -rf $(B)

## help: this list
help:
	@sed -n 's/^## /  make /p' Makefile
	@awk '!/^#/ { at = index($$0, ","); id = substr($$0, 1, at - 1); if (id == "id") next; \
	  text = $$0; for (k = 0; k < 7; ++k) text = substr(text, index(text, ",") + 1); \
	  gsub(/"/, "", text); printf "  make %s: %s\n", (id ~ /^x/ ? id : "fig" id), text }' figures/figures.ecsv
	@echo "Variables: DEPS=skip (install nothing), PYTHON=..., JOBS=..., LAUNCH=... (put before every program),"
	@echo "  THREADS=... (of each program), QUICK=1 (coarse, into $(B)/quick)"

# What has no rule is mistyped.
.DEFAULT:
	$(error '$@': there is no such target or file (allowed: what `make help` lists))
