# Burnish: builds the core (cxx/), the FreeFEM plugin (plugins/) and the tests, and runs the cases.
#   make                  same as make build                make help    every target in a line
#   make case-rolling OPTIONS="-element P1 -mu 0.3"         make run OPTIONS=...
#   make NO_INSTALL=1 run    names missing Debian packages instead of installing them
#   make PACKAGES=true run   does not look for packages (another system than Debian)
#   make GROUP=1             compiles every file for itself: slower at first, faster after a change
# All products go to $(BUILD); two runs of make in one tree wait for each other.
BUILD    ?= build
FREEFEM  ?= FreeFem++
PYTHON   ?= /usr/bin/python3
PACKAGES ?= .ci/packages
OPTIMIZE ?= -O2
TEST_OPTIMIZE ?= -O1
GROUP    ?= 8
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
# BLAS and LAPACK by their run-time names: whatever the system's alternatives select counts
LIBRARIES ?= -lcholmod -lumfpack -l:liblapack.so.3 -l:libblas.so.3 -lginac -lcln $(OCC_LIBRARIES) -ldl
# (from OpenCASCADE 7.8 on: -lTKDESTEP for the first two)
OCC_LIBRARIES ?= -lTKSTEP -lTKXSBase -lTKTopAlgo -lTKBRep -lTKGeomBase -lTKG3d -lTKG2d -lTKMath -lTKernel

# gcc collects garbage a tenth of its time otherwise
COLLECT := $(if $(findstring clang,$(shell $(CXX) --version)),,--param ggc-min-heapsize=1000000)
FLAGS = -std=c++17 $(OPTIMIZE) -DNDEBUG -fPIC -ffp-contract=off -Wall -Wextra -Wno-subobject-linkage $(COLLECT) -I. -Icxx \
        -isystem $(EIGEN_INCLUDE) -isystem $(SPARSE_INCLUDE) -isystem $(OCC_INCLUDE) $(CPPFLAGS) $(CXXFLAGS)
PLUGIN_FLAGS = -isystem $(FREEFEM_INCLUDE) -Wno-mismatched-new-delete

# --- sources and products ----------------------------------------------------------------------------------
sources   = $(sort $(shell find $(wildcard $(1)) -name '*.cpp' 2>/dev/null </dev/null))
# Up to $(GROUP) files of a folder are compiled as one, .ci/group. A group is one word, a|b|c; its object is named after
# the first and the last, so that no object is taken for another group's.
groups    = $(shell printf '%s\n' $(1) | awk -v most=$(GROUP) '{ folder = $$0; sub("/[^/]*$$", "", folder); \
              if (folder != last || ++n > most) { printf " "; n = 1 } else printf "|"; printf "%s", $$0; last = folder }')
members   = $(subst |, ,$(1))
object    = $(BUILD)/obj/$(basename $(firstword $(members)))$(if $(word 2,$(members)),..$(basename $(notdir $(lastword $(members))))).o
objects   = $(if $(strip $(1)),$(foreach g,$(call groups,$(1)),$(call object,$(g))))
SUITES   := unit plugin verification regression long labs viewers manual
PROGRAMS := unit verification long benchmark
CORE     := $(BUILD)/libburnish.a
PLUGIN   := $(BUILD)/plugins/burnish.so
# gmsh is linked with this one only, which the core opens when a .geo file is to be read; it looks for it beside
# itself, then in ../plugins; so it is with OpenCASCADE and CAD files
GMSH     := $(BUILD)/plugins/burnish_gmsh.so
CAD      := $(BUILD)/plugins/burnish_cad.so
WRAPPER  := $(BUILD)/burnish
GMSH_SOURCES   := cxx/cad/companion_gmsh/burnish_gmsh.cpp
CAD_SOURCES    := cxx/cad/companion_occ/burnish_cad.cpp
CXX_SOURCES    := $(filter-out $(GMSH_SOURCES) $(CAD_SOURCES),$(call sources,cxx))
PLUGIN_SOURCES := $(sort $(wildcard plugins/*.cpp))
$(foreach p,$(PROGRAMS),$(eval SOURCES_$(p) := $(if $(wildcard tests/$(p)),$(call sources,tests/$(p)))))
ALL_SOURCES := $(CXX_SOURCES) $(GMSH_SOURCES) $(CAD_SOURCES) $(PLUGIN_SOURCES) $(foreach p,$(PROGRAMS),$(SOURCES_$(p)))

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

# --- environment of every script: our folders first, then FreeFEM's ------------------------------------------
EDP_FOLDERS := run cases mesh rivals
space   := $(subst ,, )
LOAD    := $(abspath $(BUILD)/plugins);$(FREEFEM_LOAD)
INCLUDE := $(CURDIR)/edp;$(subst $(space),;,$(addprefix $(CURDIR)/edp/,$(EDP_FOLDERS)));$(FREEFEM_IDP)
export FF_LOADPATH    := $(LOAD)
export FF_INCLUDEPATH := $(INCLUDE)
export PYTHON
export OPENBLAS_NUM_THREADS ?= 1

define WRAPPER_TEXT
#!/bin/sh
# $(notdir $(WRAPPER)) SCRIPT.edp [OPTIONS]: runs a FreeFEM script with Burnish's folders set. Made by make.
usage() {
  echo "usage: burnish SCRIPT.edp [OPTIONS]      runs a FreeFEM script with Burnish"
  echo "       burnish SCRIPT.edp -h             lists the script's options with default, unit and meaning"
  echo "       burnish help [NAME]               the reference: contact.add, rcRun, tolerance=, summary, exit, ..."
  echo "       burnish new NAME                  makes a folder NAME with a scene that runs, to be changed"
  echo "FreeFEM's own options, such as -v 1 (its messages) and -wg (its windows), go before the script."
}
case $$1 in
  help) shift; exec "$${PYTHON:-$(PYTHON)}" -B "$(CURDIR)/edp/manual/reference/help.py" "$$@" ;;
  new) shift; exec "$${PYTHON:-$(PYTHON)}" -B "$(CURDIR)/edp/template/new.py" "$$@" ;;
esac
script=
for word in "$$@"; do
  case $$word in *.edp) script=$$word; break ;; esac
done
if [ -z "$$script" ]; then
  case $$1 in -h | --help) usage; exit 0 ;; esac
  { [ $$# -gt 0 ] && echo "burnish: no script among the words \"$$*\": expected a file that ends in .edp"; usage; } >&2
  exit 20
fi
[ -f "$$script" ] && [ -r "$$script" ] || { echo "burnish: no script \"$$script\" that can be read" >&2; exit 20; }
export FF_LOADPATH="$(LOAD)$${FF_LOADPATH:+;$$FF_LOADPATH}"
export FF_INCLUDEPATH="$(INCLUDE)$${FF_INCLUDEPATH:+;$$FF_INCLUDEPATH}"
export BURNISH_TOP="$(CURDIR)" BURNISH="$${BURNISH:-$(abspath $(WRAPPER))}" PYTHON="$${PYTHON:-$(PYTHON)}" OPENBLAS_NUM_THREADS="$${OPENBLAS_NUM_THREADS:-1}"
exec $(FREEFEM) -nw -v 0 "$$@"
endef
export WRAPPER_TEXT

# --- commands --------------------------------------------------------------------------------------------------
# Recursion with all cores, unless the user said -j; the lock keeps two makes out of one folder.
COMPILE = +@mkdir -p $(BUILD) && flock $(BUILD)/lock $(MAKE) -s --no-print-directory \
          $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS))
TEST    = BURNISH=$(abspath $(WRAPPER)) BUILD=$(abspath $(BUILD)) JOBS=$(JOBS) tests/run_scripts.sh

.PHONY: build run run-fine figures tables sweep explore stability chart references chart-quick bench-peers test $(SUITES:%=test-%) bench bench-growth install uninstall docs packages format format-check clean help FORCE
.PHONY: compile programs sanitize sanitized fuzz
.DELETE_ON_ERROR:
.SUFFIXES:

build: packages ## build the core, the plugin and the wrapper build/burnish (also plain make)
	$(COMPILE) compile

run: case-rolling ## example 1 of the article with default options; results in out/rolling

run-fine: OPTIONS := -element P1 -inner 40 -outer 1200 -sides 80 $(OPTIONS)
run-fine: case-rolling ## the same on the article's mesh, P1 with 40/1200/80 divisions

case-%: build ## run cases/NAME/NAME.edp, options in OPTIONS="..."
	$(if $(wildcard cases/$*/$*.edp),,$(error no case $*; there are: $(CASES)))
	@$(WRAPPER) cases/$*/$*.edp $(OPTIONS)

figures: packages ## draw the pictures of out/CASE again, CASE=rolling unless given; CASE=all: runs of cases/figures.csv, pictures in the tree
	$(if $(filter all,$(CASE)),@BURNISH='$(abspath $(WRAPPER))' JOBS='$(JOBS)' $(PYTHON) cases/figures.py '$(OPTIONS)',\
	  $(PYTHON) cases/$(CASE)/plot.py out/$(CASE))

tables: build ## measure the tables in the READMEs of cases/rolling and cases/planetary again, OPTIONS="--keep rolling"
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) cases/tables.py $(OPTIONS)

sweep: build ## run CASE for all values of VARY="R=14e-3:20e-3:4 mu=0.2,0.3", or find the option BY for a TARGET: cases/sweep/sweep.sh
	@CASE='$(CASE)' VARY='$(VARY)' OPTIONS='$(OPTIONS)' RESULT='$(RESULT)' JOBS='$(JOBS)' SSH='$(SSH)' SAMPLES='$(SAMPLES)' \
	  SEED='$(SEED)' TARGET='$(TARGET)' BY='$(BY)' TOLERANCE='$(TOLERANCE)' \
	  BURNISH='$(abspath $(WRAPPER))' cases/sweep/sweep.sh

explore: build ## a sweep as one page, out/sweep/CASE/explore.html: sliders for the varied options; pictures and curves follow
	@EXPLORE=1 CASE='$(CASE)' VARY='$(VARY)' OPTIONS='$(OPTIONS)' RESULT='$(RESULT)' JOBS='$(JOBS)' SSH='$(SSH)' SAMPLES='$(SAMPLES)' \
	  SEED='$(SEED)' BURNISH='$(abspath $(WRAPPER))' cases/sweep/sweep.sh

stability: build ## the map of what can go wrong, out/stability/map.png; OPTIONS="--only snap --references --store": tests/stability/run.py
	@BURNISH='$(abspath $(WRAPPER))' JOBS='$(JOBS)' $(PYTHON) tests/stability/run.py $(OPTIONS)

chart: build ## speed against accuracy of our methods and their rivals, out/chart (half an hour); OPTIONS="--only slip --repeat 5": tests/chart/run.py
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/chart/run.py $(OPTIONS)

references: build ## reference runs of the chart's scenes into tests/chart/references.csv and curves.csv
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/chart/run.py --references --none $(OPTIONS)

bench-peers: build ## CalculiX (installed) and Ipopt against ours in interleaved pairs, as ratios, tests/peers; OPTIONS="--only Ipopt --store"
	@$(PACKAGES) peers
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) -B tests/peers/bench.py $(OPTIONS)

chart-quick: build ## the same on coarse meshes, two minutes
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/chart/run.py --quick $(OPTIONS)

test: packages format-check ## all quick tests: format, unit, plugin, verification, regression (a quarter of an hour on two cores)
	$(if $(stray),$(error in no suite: $(stray)))
	$(COMPILE) compile $(call program,unit) $(call program,verification)
	@$(TEST) $(call suite,regression verification plugin unit)

test-unit: ## GoogleTest programs of the core, tests/unit
test-plugin: ## the plugin through scripts, and every error message: tests/plugin, tests/errors, tests/shell
test-verification: ## problems with known answers, tests/verification
test-regression: ## coarse cases against stored numbers, tests/regression
test-long: ## slow tests, tests/long
test-labs: ## scripts, answers, plots and notebooks of the labs in cases/labs (three minutes)
test-manual: ## the commands that the manual prints, the long ones, too (some minutes)
test-viewers: ## files and pages in the programs that show them, VTK and Chromium, tests/viewers (installs both)
$(SUITES:%=test-%): test-%: packages
	$(COMPILE) $(if $(call scripts,$*),compile,$(WRAPPER)) $(call program,$*)
	@$(TEST) $(call suite,$*)

test-manual: export TIMEOUT ?= 3000
test-viewers: viewers
test-labs: notebooks
.PHONY: viewers notebooks
viewers:
	@$(PACKAGES) viewers
notebooks:
	@$(PACKAGES) labs

# FreeFEM itself is not instrumented: the run-time libraries come before it. What it leaks, how it pairs new with free and
# what it defines twice is not ours.
SANITIZED   = $(BUILD)/sanitize
# Of undefined behavior what the sanitizer of addresses does not see; the rest doubles the time to compile.
UNDEFINED   = bounds,shift,signed-integer-overflow,integer-divide-by-zero,float-cast-overflow,return,bool,enum,unreachable,vla-bound
SANITIZERS  = -fsanitize=address,$(UNDEFINED) -fno-sanitize-recover=$(UNDEFINED)
SANITIZER_LIBRARIES = $(shell $(CXX) -print-file-name=libasan.so):$(shell $(CXX) -print-file-name=libubsan.so)
START_SANITIZER     = $(abspath $(SANITIZED))/start_sanitizer.so
# What limits the memory: the sanitizer needs terabytes of addresses.
UNSANITIZED         = MemoryLimit*
export ASAN_OPTIONS  ?= detect_leaks=0:alloc_dealloc_mismatch=0:detect_odr_violation=0
export UBSAN_OPTIONS ?= print_stacktrace=1
sanitize: packages ## unit, verification and plugin tests and one case with the sanitizers of addresses and undefined behavior (an hour)
	+@$(MAKE) -s --no-print-directory BUILD='$(SANITIZED)' PACKAGES=true LDFLAGS='$(LDFLAGS) $(SANITIZERS)' \
	  OPTIMIZE='-O1 -g1 -fno-omit-frame-pointer $(SANITIZERS)' TEST_OPTIMIZE='-O1' \
	  FREEFEM='env LD_PRELOAD=$(SANITIZER_LIBRARIES):$(START_SANITIZER) $(FREEFEM)' sanitized

sanitized: compile programs $(BUILD)/start_sanitizer.so
	@TIMEOUT=3000 GTEST_FILTER='-$(UNSANITIZED)' $(TEST) $(call suite,unit verification plugin) tests/regression/hertz.sh

$(BUILD)/start_sanitizer.so: tests/support/start_sanitizer.cpp
	@$(CXX) -shared -fPIC -Wl,-z,initfirst $< -o $@

fuzz: build ## mutated formulas, CAD files, matrices, scripts, a quarter of an hour: FUZZ_SECONDS=480 SEED=1
	@$(PACKAGES) fuzz
	$(COMPILE) $(call program,long)
	@$(call program,long) --gtest_brief=1 --gtest_filter='*uzz*'
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/fuzz/fuzz.py $(or $(FUZZ_SECONDS),480) $(SEED)

bench: build ## kernels and whole scenes against the ratios of the last release (ten minutes); OPTIONS="--kernels --store": tests/benchmark/bench.py
	@$(PACKAGES) bench
	$(COMPILE) $(or $(call program,benchmark),$(error no programs in tests/benchmark))
	@BURNISH='$(abspath $(WRAPPER))' BENCHMARK='$(abspath $(call program,benchmark))' $(PYTHON) tests/benchmark/bench.py $(OPTIONS)

bench-growth: build ## time and memory of some ten steps from 1 000 to 130 000 nodes (ten minutes); OPTIONS="--most 20"
	@BURNISH='$(abspath $(WRAPPER))' $(PYTHON) tests/benchmark/bench.py --growth $(OPTIONS)

# What a script needs at run time: plugin, script library, pictures and sweeps, the wrapper with the paths of that place.
SHARE = $(DESTDIR)$(PREFIX)/share/burnish
install: build ## install for all users: PREFIX=/usr/local, DESTDIR=; the lines for plain FreeFem++ are printed
	@install -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/lib/burnish $(SHARE)/cases
	@install -m 644 $(PLUGIN) $(GMSH) $(CAD) $(DESTDIR)$(PREFIX)/lib/burnish
	@rm -rf $(SHARE)/edp $(SHARE)/plugins $(SHARE)/cases && install -d $(SHARE)/cases
	@cp -r edp $(SHARE)/edp && cp -r cases/plotting cases/sweep $(SHARE)/cases && find $(SHARE) -name __pycache__ -exec rm -rf {} +
	@cp --parents plugins/*.cpp cases/*/*.edp cases/*/*.idp $(SHARE)  # their heads and options: burnish help
	@sed -e 's#$(abspath $(BUILD))/plugins#@@/lib/burnish#g' -e 's#$(abspath $(WRAPPER))#@@/bin/burnish#g' \
	  -e 's#$(CURDIR)#@@/share/burnish#g' -e 's#@@#$(PREFIX)#g' $(WRAPPER) >$(DESTDIR)$(PREFIX)/bin/burnish
	@chmod 755 $(DESTDIR)$(PREFIX)/bin/burnish
	@printf '%s\n' 'loadpath += "$(PREFIX)/lib/burnish"' 'loadpath += "$(FREEFEM_LOAD)"' \
	  $(foreach d,edp $(EDP_FOLDERS:%=edp/%),'includepath += "$(PREFIX)/share/burnish/$(d)"') 'includepath += "$(FREEFEM_IDP)"' >$(SHARE)/freefem++.pref
	@echo "installed: $(PREFIX)/bin/burnish SCRIPT.edp. For plain FreeFem++ add to ~/.freefem++.pref the lines of $(PREFIX)/share/burnish/freefem++.pref:"
	@cat $(SHARE)/freefem++.pref

uninstall: ## remove what make install has put there
	rm -rf $(DESTDIR)$(PREFIX)/bin/burnish $(DESTDIR)$(PREFIX)/lib/burnish $(SHARE)

docs: ## the manual as a site, out/docs/index.html: works offline, without JavaScript
	@$(PACKAGES) docs
	@rm -rf out/docs && mkdir -p out/docs
	@$(PYTHON) edp/manual/reference/generate.py out/reference
	@$(PYTHON) -m sphinx -q -W --keep-going -b html -c edp/manual -d $(BUILD)/doctrees . out/docs
	@cp edp/manual/redirect.html out/docs/index.html
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

# --- rules of compilation ----------------------------------------------------------------------------------------
compile: $(CORE) $(WRAPPER) $(PLUGIN) $(GMSH) $(CAD)
programs: $(call program,unit) $(call program,verification)

# $(call keep,TEXT): write TEXT to the target only if it changed, so that only real changes rebuild
keep = @mkdir -p $(@D) && { [ -f $@ ] && printf '%s\n' "$(1)" | cmp -s - $@ || printf '%s\n' "$(1)" >$@; }
$(BUILD)/flags: FORCE
	$(call keep,$(CXX) $(FLAGS) $(TEST_OPTIMIZE) $(PLUGIN_FLAGS) $(LIBRARIES))
$(BUILD)/sources: FORCE
	$(call keep,$(ALL_SOURCES))
$(WRAPPER): FORCE
	$(call keep,$$WRAPPER_TEXT)
	@[ -x $@ ] || chmod +x $@

$(BUILD)/obj/plugins/%: GROUP_FLAGS = $(PLUGIN_FLAGS)
$(BUILD)/obj/tests/%:   GROUP_FLAGS = -Itests $(TEST_OPTIMIZE)
$(foreach g,$(call groups,$(ALL_SOURCES)),$(eval $(call object,$(g)): $(call members,$(g))))
$(BUILD)/obj/%.o: $(BUILD)/flags .ci/group
	@mkdir -p $(@D)
	@echo "compile $(patsubst $(BUILD)/obj/%.o,%,$@)"
	@.ci/group $(filter %.cpp,$^) >$(@:.o=.cc)
	@$(CXX) $(FLAGS) $(GROUP_FLAGS) $(READ_BEFORE) -MMD -MP -c $(@:.o=.cc) -o $@

# Eigen and the standard library are read once for the core, once with FreeFEM's headers for the plugin, and once with GoogleTest
# for the tests: a third of the time.
$(BUILD)/obj/cxx/%:              READ_BEFORE = -include $(BUILD)/read/core.hpp
$(BUILD)/obj/plugins/%:          READ_BEFORE = -include $(BUILD)/read/plugins.hpp
$(BUILD)/obj/tests/unit/%:         READ_BEFORE = -include $(BUILD)/read/tests.hpp
$(BUILD)/obj/tests/verification/%: READ_BEFORE = -include $(BUILD)/read/tests.hpp
$(call objects,$(CXX_SOURCES) $(GMSH_SOURCES) $(CAD_SOURCES)): $(BUILD)/read/core.hpp.gch
$(call objects,$(PLUGIN_SOURCES)): $(BUILD)/read/plugins.hpp.gch
$(call objects,$(SOURCES_unit) $(SOURCES_verification)): $(BUILD)/read/tests.hpp.gch
$(BUILD)/read/core.hpp.gch:  cxx/base/precompiled.hpp
$(BUILD)/read/plugins.hpp.gch: plugins/precompiled.hpp cxx/base/precompiled.hpp
$(BUILD)/read/plugins.hpp.gch: GROUP_FLAGS = $(PLUGIN_FLAGS)
$(BUILD)/read/tests.hpp.gch: tests/support/precompiled.hpp cxx/base/precompiled.hpp
$(BUILD)/read/tests.hpp.gch: GROUP_FLAGS = -Itests $(TEST_OPTIMIZE)
$(BUILD)/read/%.hpp.gch: $(BUILD)/flags
	@mkdir -p $(@D)
	@echo "read    $(firstword $(filter %/precompiled.hpp,$^))"
	@cp $(firstword $(filter %/precompiled.hpp,$^)) $(BUILD)/read/$*.hpp
	@$(CXX) $(FLAGS) $(GROUP_FLAGS) -x c++-header $(BUILD)/read/$*.hpp -o $@

# Linked under another name and moved: a program that is running keeps the old file.
$(CORE): $(call objects,$(CXX_SOURCES)) $(BUILD)/sources
	@rm -f $@ && ar rcs $@ $(filter %.o,$^)
$(PLUGIN): $(call objects,$(PLUGIN_SOURCES)) $(CORE)
	$(if $(PLUGIN_SOURCES),,$(error no sources in plugins/))
	@mkdir -p $(@D)
	@echo "link    $@"
	@$(CXX) -shared $(LDFLAGS) $(filter %.o,$^) $(CORE) -Wl,--as-needed $(LIBRARIES) -o $@.new && mv $@.new $@

$(CAD): $(call objects,$(CAD_SOURCES)) $(CORE)
	@mkdir -p $(@D)
	@echo "link    $@"
	@$(CXX) -shared $(LDFLAGS) $(filter %.o,$^) $(CORE) -Wl,--as-needed $(LIBRARIES) -o $@.new && mv $@.new $@

$(GMSH): $(call objects,$(GMSH_SOURCES))
	@mkdir -p $(@D)
	@echo "link    $@"
	@$(CXX) -shared $(LDFLAGS) $^ -lgmsh -o $@.new && mv $@.new $@

define program_rule
$(BUILD)/tests/$(1): $(call objects,$(SOURCES_$(1))) $(CORE) | $(GMSH) $(CAD)
	@mkdir -p $$(@D)
	@echo "link    $$@"
	@$$(CXX) $$(LDFLAGS) $$(filter %.o,$$^) $$(CORE) $(2) -pthread -Wl,--as-needed $$(LIBRARIES) -o $$@.new \
	  && mv $$@.new $$@
endef
$(foreach p,unit verification long,$(eval $(call program_rule,$(p),-lgtest_main -lgtest)))
$(eval $(call program_rule,benchmark,-lbenchmark_main -lbenchmark))

-include $(patsubst %.o,%.d,$(call objects,$(ALL_SOURCES)))
