# How Burnish is compiled: included by the Makefile, which has the places and the products.
# what was compiled before need not be compiled again, where there is a ccache; it takes headers that are read before with these words
CCACHE := $(shell command -v ccache)
export CCACHE_SLOPPINESS ?= pch_defines,time_macros,include_file_mtime,include_file_ctime
CLANG := $(findstring clang,$(CXX))
FLAGS = -std=c++17 $(OPTIMIZE) -DNDEBUG -fPIC -ffp-contract=off -Wall -Wextra $(if $(CLANG),,-Wno-subobject-linkage) \
        $(if $(CCACHE),$(if $(CLANG),-Xclang -fno-pch-timestamp,-fpch-preprocess)) -I. -Icxx \
        -isystem $(EIGEN_INCLUDE) -isystem $(SPARSE_INCLUDE) -isystem $(OCC_INCLUDE) $(CPPFLAGS) $(CXXFLAGS)
PLUGIN_FLAGS = $(GLUE_OPTIMIZE) -isystem $(FREEFEM_INCLUDE) -Wno-mismatched-new-delete

sources   = $(sort $(shell find $(wildcard $(1)) -name '*.cpp' 2>/dev/null </dev/null))
# Up to $(GROUP) files of a folder are compiled as one, .ci/groups; the object of a group a|b|c is named after the first and the last, so
# that no object is taken for another group's.
groups    = $(shell .ci/groups $(GROUP) $(1))
members   = $(subst |, ,$(1))
object    = $(BUILD)/obj/$(basename $(firstword $(members)))$(if $(word 2,$(members)),..$(basename $(notdir $(lastword $(members))))).o
objects   = $(if $(strip $(1)),$(foreach g,$(call groups,$(1)),$(call object,$(g))))
GMSH_SOURCES   := $(call sources,cxx/cad/companion_gmsh)
CAD_SOURCES    := cxx/cad/companion_occ/burnish_cad.cpp
OCC_SOURCES    := $(call sources,cxx/cad/occ)
MPI_SOURCES    := $(call sources,cxx/parallel/companion_mpi)
OPENMP_SOURCES := cxx/solver/companion_openmp/burnish_openmp.cpp
CXX_SOURCES    := $(filter-out $(GMSH_SOURCES) $(CAD_SOURCES) $(OCC_SOURCES) $(MPI_SOURCES) $(OPENMP_SOURCES),$(call sources,cxx))
PLUGIN_SOURCES := $(sort $(wildcard plugins/*.cpp))
$(foreach p,$(PROGRAMS),$(eval SOURCES_$(p) := $(if $(wildcard tests/$(p)),$(call sources,tests/$(p)))))
ALL_SOURCES := $(CXX_SOURCES) $(GMSH_SOURCES) $(CAD_SOURCES) $(OCC_SOURCES) $(MPI_SOURCES) $(OPENMP_SOURCES) $(PLUGIN_SOURCES) $(foreach p,$(PROGRAMS),$(SOURCES_$(p)))

# --- rules of compilation ----------------------------------------------------------------------------------------
# $(call keep,TEXT): write TEXT to the target only if it changed, so that only real changes rebuild
keep = @mkdir -p $(@D) && { [ -f $@ ] && printf '%s\n' "$(1)" | cmp -s - $@ || printf '%s\n' "$(1)" >$@; }
# (.ci/build counts what is to be done after both are there)
$(BUILD)/flags: $(if $(COUNTING),,FORCE)
	$(call keep,$(CXX) $(FLAGS) $(GLUE_OPTIMIZE) $(PLUGIN_FLAGS) $(LIBRARIES))
$(BUILD)/sources: $(if $(COUNTING),,FORCE)
	$(call keep,$(ALL_SOURCES))
$(WRAPPER): FORCE
	@.ci/wrapper '$(CURDIR)' '$(abspath $(BUILD)/plugins)' '$(abspath $@)' >$@.new && chmod +x $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

$(BUILD)/obj/cxx/parallel/companion_mpi/%: GROUP_FLAGS = -isystem $(MPI_INCLUDE)$(if $(filter-out /usr/include,$(MUMPS_INCLUDE)), -isystem $(MUMPS_INCLUDE))
$(BUILD)/obj/plugins/%: GROUP_FLAGS = $(PLUGIN_FLAGS)
$(BUILD)/obj/tests/%:   GROUP_FLAGS = -Itests $(GLUE_OPTIMIZE)
# rooms of the core without kernels: a fifth less to compile
UNHURRIED := cad checkpoint diagnosis output remesh script shapes
$(foreach r,$(UNHURRIED),$(eval $(BUILD)/obj/cxx/$(r)/%: GROUP_FLAGS = $(GLUE_OPTIMIZE)))
$(foreach g,$(call groups,$(ALL_SOURCES)),$(eval $(call object,$(g)): $(call members,$(g))) $(eval $(call object,$(g)): MEMBERS = $(call members,$(g))))
$(BUILD)/obj/%.o: $(BUILD)/flags .ci/group
	@mkdir -p $(@D)
	@.ci/said $(BUILD) "compile $(patsubst $(BUILD)/obj/%.o,%,$@)"
	@.ci/group $(MEMBERS) >$(@:.o=.cc)
	@$(CCACHE) $(CXX) $(FLAGS) $(GROUP_FLAGS) $(READ_BEFORE) -MMD -MP -c $(@:.o=.cc) -o $@

# Eigen and the standard library are read once for the core, once with FreeFEM's headers for the plugin, and once with GoogleTest
# for the tests: a third of the time.
$(BUILD)/obj/cxx/%:              READ_BEFORE = -include $(BUILD)/read/core.hpp
$(foreach r,$(UNHURRIED),$(eval $(BUILD)/obj/cxx/$(r)/%: READ_BEFORE = -include $(BUILD)/read/unhurried.hpp))
$(BUILD)/obj/plugins/%:          READ_BEFORE = -include $(BUILD)/read/plugins.hpp
$(BUILD)/obj/tests/unit/%:         READ_BEFORE = -include $(BUILD)/read/tests.hpp
$(BUILD)/obj/tests/verification/%: READ_BEFORE = -include $(BUILD)/read/tests.hpp
$(BUILD)/obj/tests/unit/% $(BUILD)/obj/tests/verification/% $(BUILD)/read/tests.hpp.gch: GROUP_FLAGS = -Itests -O0
$(call objects,$(CXX_SOURCES) $(GMSH_SOURCES) $(CAD_SOURCES) $(OCC_SOURCES) $(MPI_SOURCES) $(OPENMP_SOURCES)): \
  $(BUILD)/read/core.hpp.gch $(BUILD)/read/unhurried.hpp.gch
$(call objects,$(PLUGIN_SOURCES)): $(BUILD)/read/plugins.hpp.gch
$(call objects,$(SOURCES_unit) $(SOURCES_verification)): $(BUILD)/read/tests.hpp.gch
$(BUILD)/read/core.hpp.gch $(BUILD)/read/unhurried.hpp.gch: cxx/base/precompiled.hpp
$(BUILD)/read/unhurried.hpp.gch: GROUP_FLAGS = $(GLUE_OPTIMIZE)
$(BUILD)/read/plugins.hpp.gch: plugins/precompiled.hpp cxx/base/precompiled.hpp
$(BUILD)/read/plugins.hpp.gch: GROUP_FLAGS = $(PLUGIN_FLAGS)
$(BUILD)/read/tests.hpp.gch: tests/support/precompiled.hpp cxx/base/precompiled.hpp
$(BUILD)/read/%.hpp.gch: $(BUILD)/flags
	@mkdir -p $(@D)
	@.ci/said $(BUILD) "read    $(firstword $(filter %/precompiled.hpp,$^))"
	@cp $(firstword $(filter %/precompiled.hpp,$^)) $(BUILD)/read/$*.hpp
	@$(CCACHE) $(CXX) $(FLAGS) $(GROUP_FLAGS) -x c++-header $(BUILD)/read/$*.hpp -o $@

# Linked under another name and moved: a program that is running keeps the old file.
$(CORE): $(call objects,$(CXX_SOURCES)) $(BUILD)/sources
	@rm -f $@ && ar rcs $@ $(filter %.o,$^)
$(OCC_CORE): $(call objects,$(OCC_SOURCES)) $(BUILD)/sources
	@rm -f $@ && ar rcs $@ $(filter %.o,$^)
$(PLUGIN): $(call objects,$(PLUGIN_SOURCES)) $(CORE)
	$(if $(PLUGIN_SOURCES),,$(error no sources in plugins/))
	@mkdir -p $(@D)
	@.ci/said $(BUILD) "link    $@"
	@$(CXX) -shared $(LDFLAGS) -Wl,-Bsymbolic-functions $(filter %.o,$^) $(CORE) -Wl,--as-needed $(LIBRARIES) -o $@.new \
	  && mv $@.new $@

$(CAD): $(call objects,$(CAD_SOURCES)) $(OCC_CORE) $(CORE)
	@mkdir -p $(@D)
	@.ci/said $(BUILD) "link    $@"
	@$(CXX) -shared $(LDFLAGS) $(filter %.o,$^) $(OCC_CORE) $(CORE) -Wl,--as-needed $(LIBRARIES) -o $@.new && mv $@.new $@

$(GMSH): $(call objects,$(GMSH_SOURCES))
	@mkdir -p $(@D)
	@.ci/said $(BUILD) "link    $@"
	@$(CXX) -shared $(LDFLAGS) $^ -lgmsh -o $@.new && mv $@.new $@

$(BUILD)/plugins/burnish_openmp.so: $(call objects,$(OPENMP_SOURCES))
	@mkdir -p $(@D)
	@.ci/said $(BUILD) "link    $@"
	@$(CXX) -shared $(LDFLAGS) $^ -ldl -o $@.new && mv $@.new $@

$(BUILD)/plugins/burnish_mpi.so: $(call objects,$(MPI_SOURCES))
	@mkdir -p $(@D)
	@.ci/said $(BUILD) "link    $@"
	@$(CXX) -shared $(LDFLAGS) $^ $(MPI_LIBRARIES) -o $@.new && mv $@.new $@

define program_rule
$(BUILD)/tests/$(1): $(call objects,$(SOURCES_$(1))) $(OCC_CORE) $(CORE) | $(GMSH) $(CAD) $(OPENMP)
	@mkdir -p $$(@D)
	@.ci/said $(BUILD) "link    $$@"
	@$$(CXX) $$(LDFLAGS) $$(filter %.o,$$^) $$(OCC_CORE) $$(CORE) $(2) -pthread -Wl,--as-needed $(OCC_MODELING) $$(LIBRARIES) -o $$@.new \
	  && mv $$@.new $$@
endef
$(foreach p,unit verification long,$(eval $(call program_rule,$(p),-lgtest_main -lgtest)))
$(eval $(call program_rule,benchmark,-lbenchmark_main -lbenchmark))

-include $(patsubst %.o,%.d,$(call objects,$(ALL_SOURCES)))
