# Burnish: builds the core (cxx/), the FreeFEM plugin (plugins/) and the tests, and runs the cases.
#   make                  same as make build                make help    every target in a line
#   make case-rolling OPTIONS="-element P1 -mu 0.3"         make run OPTIONS=...
#   make NO_INSTALL=1 run    names missing Debian packages instead of installing them
#   make PACKAGES=true run   does not look for packages (another system than Debian)
#   make GROUP=1             compiles every file for itself: slower at first, faster after a change
# All products go to $(BUILD); two runs of make in one tree wait for each other.
BUILD    ?= build
# half of the time and memory of g++, which compiles it, too: make CXX=g++
ifeq ($(origin CXX),default)
CXX := clang++
endif
FREEFEM  ?= FreeFem++
FREEFEM_MPI ?= FreeFem++-mpi
MPIRUN   ?= mpirun
PYTHON   ?= /usr/bin/python3
PACKAGES ?= .ci/packages
OPTIMIZE ?= -O2
# of plugin and tests, which call the core
GLUE_OPTIMIZE ?= -O1
GROUP    ?= 12
JOBS     ?= $(shell nproc)
PREFIX   ?= /usr/local
OPTIONS  ?=
CASE     ?= rolling
# an empty environment will do: bash finds the programs, and hands the path on
SHELL := /bin/bash
export PATH := $(or $(PATH),/usr/local/bin:/usr/bin:/bin)

# Where FreeFEM, Eigen, SuiteSparse and OpenCASCADE are (Debian's places)
FREEFEM_LOAD    ?= /usr/lib/freefem++
FREEFEM_IDP     ?= /usr/include/freefem++/idp
FREEFEM_INCLUDE ?= /usr/include/freefem++
EIGEN_INCLUDE   ?= /usr/include/eigen3
SPARSE_INCLUDE  ?= /usr/include/suitesparse
OCC_INCLUDE     ?= /usr/include/opencascade
MPI_INCLUDE     ?= /usr/lib/$(shell $(CXX) -print-multiarch 2>/dev/null)/openmpi/include
MUMPS_INCLUDE   ?= /usr/include
MPI_LIBRARIES   ?= -ldmumps -lmpi -l:liblapack.so.3 -l:libblas.so.3
# BLAS and LAPACK by their run-time names: whatever the system's alternatives select counts
LIBRARIES ?= -lcholmod -lumfpack -lsuitesparseconfig -lmetis -l:liblapack.so.3 -l:libblas.so.3 -lginac -lcln $(OCC_LIBRARIES) -lz -ldl
# (from OpenCASCADE 7.8 on: -lTKDESTEP for the first two)
OCC_LIBRARIES ?= -lTKSTEP -lTKXSBase -lTKFillet -lTKMesh -lTKTopAlgo -lTKBRep -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel
# what makes CAD bodies for the tests
OCC_MODELING ?= -lTKBool -lTKBO -lTKPrim -lTKShHealing

SUITES   := unit plugin verification regression long labs viewers manual mpi
PROGRAMS := unit verification long benchmark
CORE     := $(BUILD)/libburnish.a
# of the core what reads CAD files by OpenCASCADE: no part of the plugin
OCC_CORE := $(BUILD)/libburnish_occ.a
PLUGIN   := $(BUILD)/plugins/burnish.so
# the core opens these two when a .geo or a CAD file is to be read; it looks for them beside itself, then in ../plugins
GMSH     := $(BUILD)/plugins/burnish_gmsh.so
CAD      := $(BUILD)/plugins/burnish_cad.so
# loaded by burnish before OpenMP's run time
OPENMP   := $(BUILD)/plugins/burnish_openmp.so
# ranks and factors of burnish -np, where Debian's MPI and MUMPS are (make test-mpi installs them)
MPI      := $(if $(and $(wildcard $(MPI_INCLUDE)/mpi.h),$(wildcard $(MUMPS_INCLUDE)/dmumps_c.h)),$(BUILD)/plugins/burnish_mpi.so)
WRAPPER  := $(BUILD)/burnish
# flags, lists of sources and their objects, rules of compilation
include .ci/compile.mk
.DEFAULT_GOAL := build

# What a suite runs: its GoogleTest program (every .cpp of its folder), and every .edp and .sh of its folders.
# Helpers are .idp, .hpp and .py files, or live in tests/support; stray is what would be skipped silently.
folders   = $(wildcard $(patsubst %,tests/%,$(if $(filter plugin,$(1)),plugin errors shell,$(1))))
scripts   = $(if $(call folders,$(1)),$(sort $(shell find $(call folders,$(1)) -name '*.edp' -o -name '*.sh')))
program   = $(if $(SOURCES_$(1)),$(BUILD)/tests/$(1))
suite     = $(foreach s,$(1),$(or $(strip $(call program,$(s)) $(call scripts,$(s))),$(error no tests in suite $(s))))
stray     = $(filter-out tests/run_scripts.sh tests/support/% tests/benchmark/% tests/stability/% tests/chart/% tests/peers/% $(ALL_SOURCES) \
              $(foreach s,$(SUITES),$(call scripts,$(s))),$(shell find tests -name '*.cpp' -o -name '*.edp' -o -name '*.sh'))

FORMATTED = cxx plugins tests -name '*.[ch]pp'
CASES     = $(sort $(patsubst cases/%/,%,$(dir $(wildcard cases/*/*.edp))))

# what the programs in .ci/ take from here
EDP_FOLDERS := run cases mesh rivals
export PYTHON CXX FREEFEM FREEFEM_MPI MPIRUN FREEFEM_LOAD FREEFEM_IDP EDP_FOLDERS PREFIX DESTDIR LDFLAGS JOBS MAKE
export OPENBLAS_NUM_THREADS ?= 1
# memory in huge pages, as in burnish: for all that is measured or tested
export GLIBC_TUNABLES ?= glibc.malloc.hugetlb=1

# --- commands --------------------------------------------------------------------------------------------------
# Recursion with all cores, unless the user said -j; the lock keeps two makes out of one folder.
COMPILE = +@mkdir -p $(BUILD) && flock $(BUILD)/lock .ci/build $(BUILD) $(MAKE) -s --no-print-directory \
          $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS)) --
TEST    = BURNISH=$(abspath $(WRAPPER)) BUILD=$(abspath $(BUILD)) JOBS=$(JOBS) tests/run_scripts.sh

.PHONY: build run run-fine figures tables sweep stability chart matrices references chart-quick bench-peers test $(SUITES:%=test-%) bench bench-growth bench-processes install deb try-deb try-docker uninstall docs packages format format-check clean help FORCE
.PHONY: compile compile-run programs compile-programs sanitize sanitized fuzz test-alone
.DELETE_ON_ERROR:
.SUFFIXES:

build: packages ## build the core, the plugin and the wrapper build/burnish (also plain make)
	$(COMPILE) compile

programs: packages ## build the test programs of make test
	$(COMPILE) compile compile-programs

compile: compile-run $(GMSH) $(CAD) $(MPI)
compile-run: $(CORE) $(WRAPPER) $(PLUGIN) $(OPENMP)
compile-programs: $(call program,unit) $(call program,verification)

# twice only where nothing is asked for
FORMS_FOLDER := out/rolling-forms
FORMS := -forms 1 -solver UMFPACK -inner 4 -outer 40 -sides 8 -pictures 0 -series 0 -out $(FORMS_FOLDER)
run: packages ## example 1 of the article, by forms of the script through UMFPACK (coarse), then by the core: results in out/rolling
	$(COMPILE) compile-run
	$(if $(strip $(OPTIONS)),,@mkdir -p $(FORMS_FOLDER) && echo "example 1 of the article by law and forms of the script, coarse mesh" && \
	  $(WRAPPER) cases/rolling/rolling.edp $(FORMS) >$(FORMS_FOLDER)/log.txt || { tail -n 20 $(FORMS_FOLDER)/log.txt; exit 1; })
	@$(WRAPPER) cases/rolling/rolling.edp $(OPTIONS)
	$(if $(strip $(OPTIONS)),,@$(PYTHON) cases/rolling/twice.py $(FORMS_FOLDER) out/rolling)

run-fine: OPTIONS := -element P1 -inner 40 -outer 1200 -sides 80 $(OPTIONS)
run-fine: case-rolling ## the same on the article's mesh, P1 with 40/1200/80 divisions

case-%: build ## run cases/NAME/NAME.edp, options in OPTIONS="..."
	$(if $(wildcard cases/$*/$*.edp),,$(error no case $*; there are: $(CASES)))
	@$(WRAPPER) cases/$*/$*.edp $(OPTIONS)

figures: packages ## draw all pictures of out/CASE, CASE=rolling unless given; CASE=all: runs of cases/figures.csv, pictures in the tree
	$(if $(filter all,$(CASE)),@BURNISH='$(abspath $(WRAPPER))' JOBS='$(JOBS)' $(PYTHON) cases/figures.py '$(OPTIONS)',\
	  $(if $(wildcard out/$(CASE)),,$(error out/$(CASE): no run to draw; make case-$(CASE) makes it))\
	  $(PYTHON) $(or $(wildcard cases/$(CASE)/plot.py),cases/plotting/scene.py) out/$(CASE))

tables: build ## measure the tables in the READMEs of rolling, planetary, bending, strip-rolling, u-channel, cup, leveller, roll-bending, ball, ball-rolling, burnishing, slab, block-upsetting, tilted-punch, plate-rolling, ring-rolling, of the manual's page thin-strips again, OPTIONS="--keep rolling"
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) cases/tables.py $(OPTIONS)

sweep: build ## burnish sweep for a case: make sweep CASE=rolling VARY="R=14e-3:20e-3:4 mu=0.2,0.3" OPTIONS="-outer 80": cases/sweep/sweep.py
	@$(WRAPPER) sweep $(or $(wildcard cases/$(CASE)/$(CASE).edp),$(CASE)) $(VARY) -jobs $(JOBS) $(OPTIONS)

stability: build ## the map of what can go wrong, out/stability/map.png; OPTIONS="--only snap --references --store": tests/stability/run.py
	@BURNISH='$(abspath $(WRAPPER))' JOBS='$(JOBS)' $(PYTHON) tests/stability/run.py $(OPTIONS)

chart: build ## speed against accuracy of our methods and their rivals, out/chart (half an hour); OPTIONS="--only slip --repeat 5": tests/chart/run.py
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/chart/run.py $(OPTIONS)

matrices: build ## what the article claims of its matrix, measured beside its rivals', out/matrices (ten minutes); OPTIONS="--quick": tests/chart/matrices.py
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) -B tests/chart/matrices.py $(OPTIONS)

references: build ## reference runs of the chart's scenes into tests/chart/references.csv and curves.csv
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/chart/run.py --references --none $(OPTIONS)

bench-peers: build ## CalculiX (installed) and Ipopt against ours in interleaved pairs, as ratios, tests/peers; OPTIONS="--only Ipopt --store"
	@$(PACKAGES) peers
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) -B tests/peers/bench.py $(OPTIONS)

chart-quick: build ## the same on coarse meshes, three minutes
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/chart/run.py --quick $(OPTIONS)

test: packages format-check ## all quick tests: format, unit, plugin, verification, regression, mpi (a quarter of an hour on two cores)
	$(if $(stray),$(error in no suite: $(stray)))
	@$(PACKAGES) mpi || echo "no MPI: tests/mpi is skipped"
	$(COMPILE) compile $(call program,unit) $(call program,verification)
	@$(TEST) $(call suite,unit regression verification plugin mpi)

test-unit: ## GoogleTest programs of the core, tests/unit
test-plugin: ## the plugin through scripts, and every error message: tests/plugin, tests/errors, tests/shell
test-verification: ## problems with known answers, tests/verification
test-regression: ## coarse cases against stored numbers, tests/regression
test-mpi: ## burnish -np 2 and more on small scenes, tests/mpi (half a minute; installs MUMPS and MPI)
test-long: ## slow tests, tests/long
test-labs: ## scripts, answers, plots and notebooks of the labs in cases/labs (three minutes)
test-manual: ## the commands that the manual prints, the long ones, too (some minutes)
test-alone: packages ## every header and source file compiles by itself (ten minutes)
	@.ci/alone $(FLAGS) $(PLUGIN_FLAGS)
test-viewers: ## files and pages in the programs that show them, VTK and Chromium, tests/viewers (installs both)
$(SUITES:%=test-%): test-%: packages
	$(if $(BESIDE),@$(PACKAGES) $(BESIDE))
	$(COMPILE) $(if $(call scripts,$*),compile,$(WRAPPER)) $(call program,$*)
	@$(TEST) $(call suite,$*)

test-manual test-long: export TIMEOUT ?= 3000
test-viewers: BESIDE = viewers
test-labs: BESIDE = labs
test-mpi: BESIDE = mpi

sanitize: packages ## unit, verification and plugin tests and one case with the sanitizers of addresses and undefined behavior (an hour)
	@$(PACKAGES) sanitize
	+@CXX=g++ .ci/sanitize $(BUILD)/sanitize

sanitized: compile compile-programs
	@$(TEST) $(call suite,unit verification plugin) tests/regression/hertz.sh

fuzz: build ## mutated formulas, CAD files, matrices, scripts, a quarter of an hour: FUZZ_SECONDS=480 SEED=1
	@$(PACKAGES) fuzz
	$(COMPILE) $(call program,long)
	@$(call program,long) --gtest_brief=1 --gtest_filter='*uzz*'
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/fuzz/fuzz.py $(or $(FUZZ_SECONDS),480) $(SEED)

bench: build ## kernels and whole scenes against the ratios of the last release (ten minutes); OPTIONS="--kernels --store": tests/benchmark/bench.py
	@$(PACKAGES) bench
	$(COMPILE) $(or $(call program,benchmark),$(error no programs in tests/benchmark))
	@BURNISH='$(abspath $(WRAPPER))' BENCHMARK='$(abspath $(call program,benchmark))' $(PYTHON) tests/benchmark/bench.py $(OPTIONS)

bench-growth: build ## time and memory of some ten steps, in the plane to 270 000 unknowns, in space to 200 000 (twenty minutes); OPTIONS="--most 50000"
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/benchmark/bench.py --growth $(OPTIONS)

bench-processes: ## a model of up to 64 processes; OPTIONS=--measure: beside runs on one and two, which want two quiet cores (20 minutes)
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) -B tests/benchmark/processes.py $(OPTIONS)

install: build ## install for all users: PREFIX=/usr/local, DESTDIR=; the lines for plain FreeFem++ are printed
	@.ci/install $(PLUGIN) $(OPENMP) $(GMSH) $(CAD) $(MPI)

deb: build ## the Debian package of the plugin that is built, build/burnish_VERSION_ARCHITECTURE.deb, checked by lintian
	@$(PACKAGES) deb
	@.ci/deb $(abspath $(BUILD)) $(MAKE)

try-deb: deb ## that package in a clean Debian (debootstrap, as root), by a user who is not root; seconds of each step
	@$(PACKAGES) clean
	@.ci/chroot $(abspath $(BUILD))/clean deb $(abspath $(BUILD))/burnish_*.deb

try-docker: ## the lines of edp/manual/Dockerfile in a clean Debian, without a container engine (as root, half an hour)
	@$(PACKAGES) clean
	@mkdir -p $(BUILD) && .ci/chroot $(abspath $(BUILD))/clean docker edp/manual/Dockerfile

uninstall: ## remove what make install has put there
	rm -rf $(DESTDIR)$(PREFIX)/bin/burnish $(DESTDIR)$(PREFIX)/lib/burnish $(DESTDIR)$(PREFIX)/share/burnish

docs: build ## the manual as a site, out/docs/index.html, with the pictures of its scripts, and as out/docs/burnish.pdf: works offline, without JavaScript
	@$(PACKAGES) docs
	@BURNISH='$(abspath $(WRAPPER))' JOBS='$(JOBS)' $(PYTHON) edp/manual/runs.py out/manual
	@rm -rf out/docs && mkdir -p out/docs
	@$(PYTHON) edp/manual/reference/generate.py out/reference
	@$(PYTHON) -m sphinx -q -W -E --keep-going -b html -c edp/manual -d $(BUILD)/doctrees . out/docs
	@cp edp/manual/redirect.html out/docs/index.html
	@rm -rf $(BUILD)/single && $(PYTHON) -m sphinx -q -W -E --keep-going -b singlehtml -c edp/manual -d $(BUILD)/doctrees-single . $(BUILD)/single
	@$(PYTHON) -B edp/manual/pdf.py $(BUILD)/single/edp/manual/index.html out/docs/burnish.pdf
	@$(PYTHON) edp/manual/links.py out/docs
	@echo "out/docs/index.html"

packages: ## look for the Debian packages needed and install what is missing
	@$(PACKAGES)

format: ## clang-format on all C++ files
	@$(PACKAGES) format
	find $(FORMATTED) -exec clang-format -i {} +

format-check: ## are all C++ files as make format leaves them?
	@$(PACKAGES) format
	@find $(FORMATTED) -exec clang-format --dry-run -Werror {} + || { echo "not formatted: run make format"; exit 1; }

clean: ## remove everything built (results in out/ stay)
	rm -rf $(BUILD)

help: ## this list
	@awk -F':.*## ' '/^[a-z%-]+:.*## / {sub("%", "NAME", $$1); printf "make %-18s %s\n", $$1, $$2}' Makefile

