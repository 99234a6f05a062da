# A thin wrapper over CMake's presets. PRESET=release|ci|sanitize|tsan chooses one; JOBS is the number of
# compilers that run at once.
PRESET ?= release
JOBS ?= $(shell nproc)
BUILD := build/$(PRESET)
LANCRET := $(BUILD)/tools/lancret
SOURCES := $(shell git ls-files '*.h' '*.cpp' 2>/dev/null)

.PHONY: all preview evaluate gallery blender-addon test test-slow sanitize sanitize-readers bench format format-check lint deps clean

all: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET)
	cmake --build --preset $(PRESET) --parallel $(JOBS)

# Installs missing Debian packages; does nothing if there are none.
deps:
	@scripts/install-deps

# The main job on a groom that Lancret makes by itself: simulated guides, pictures of a turn of the head and a
# report of the check in out/.
preview: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target lancret
	@mkdir -p out
	$(LANCRET) simulate examples/made_groom.toml --frames 1-24 -o out/cache.h5 --restart --stats out/simulate.json
	$(LANCRET) preview examples/made_groom.toml -o out/preview.png --stats out/preview.json
	$(LANCRET) preview out/cache.h5 --frames 9-13 --size 320x320 --samples 16 -o out/turn.####.png
	$(LANCRET) check out/cache.h5 --frames 9-13 --json out/check.json
	@echo "The pictures are out/preview.png and out/turn.*.png, the report of the check is out/check.json."

# Every blend on made grooms, straight to tightly curled: tables, figures and pictures in out/evaluate/.
# Other grooms: make evaluate GROOMS="groom.hair other.toml".
GROOMS ?= $(wildcard examples/evaluate/*.toml)
evaluate: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target lancret
	@mkdir -p out/evaluate
	@set -e; for groom in $(GROOMS); do name=$$(basename $${groom%.*}); \
	  $(LANCRET) evaluate $$groom --json out/evaluate/$$name.json --image out/evaluate/$$name.png --size 240x300; \
	done

# Pictures of many kinds of hair in out/gallery/: straight, wavy and tightly curled; brown, blond and black; fur,
# grass, depth of field, levels of detail, motion blur.
gallery: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target lancret
	@mkdir -p out/gallery
	@set -e; for groom in examples/gallery/*.toml examples/grass.toml; do name=$$(basename $${groom%.*}); \
	  $(LANCRET) preview $$groom -o out/gallery/$$name.png; \
	done
	@set -e; for density in 1 0.1 0.01; do \
	  $(LANCRET) preview examples/made_groom.toml --strands 100000 --density $$density --size 320x320 --samples 64 -o out/gallery/density_$$density.png; \
	done
	$(LANCRET) simulate examples/made_groom.toml --frames 1-12 -o out/gallery/turn.h5 --restart
	$(LANCRET) preview out/gallery/turn.h5 --frame 11 --shutter 0,0.8 --motion-samples 5 --size 480x480 -o out/gallery/turn.png

# The Blender add-on as a zip that Blender installs, with the Python package and the library: docs/blender.md.
blender-addon: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target lancret_plugin
	python3 python/blender/build_zip.py $(BUILD)/liblancret_procedural.so out/lancret_blender.zip

# The Python tests run in an environment that is made once and kept in ~/.cache/lancret.
test: deps
	scripts/test-python
	cmake --preset $(PRESET) -DLANCRET_TESTS=ON
	cmake --build --preset $(PRESET) --parallel $(JOBS)
	ctest --preset $(PRESET) --parallel $(JOBS) --label-exclude slow

# Also compares with Mitsuba and tests the add-on in Blender's module bpy, both from PyPI.
test-slow: deps
	scripts/install-deps --bpy
	scripts/bpy-python 4.5
	scripts/bpy-python 5.0
	cmake --preset $(PRESET) -DLANCRET_TESTS=ON
	cmake --build --preset $(PRESET) --parallel $(JOBS)
	LANCRET_MITSUBA_PYTHON=$$(scripts/mitsuba-python) ctest --preset $(PRESET) --label-regex slow

bench: deps
	cmake --preset $(PRESET) -DLANCRET_BENCH=ON
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target lancret_bench lancret_pipeline_bench
	$(BUILD)/bench/lancret_pipeline_bench $(BUILD)/tools/lancret examples/made_groom.toml
	$(BUILD)/bench/lancret_bench --benchmark_counters_tabular=true

format:
	@clang-format -i $(SOURCES)

format-check:
	@clang-format --dry-run --Werror $(SOURCES)

# clang-tidy on the sources that differ from LINT_BASE (default: the last commit that was pushed, else the one before
# this); everything: make lint LINT_BASE=
LINT_BASE ?= $(shell git rev-parse -q --verify origin/main || git rev-parse -q --verify HEAD~1)
LINT_FILES = $(if $(LINT_BASE),$(shell git diff --name-only --diff-filter=d $(LINT_BASE) -- '*.cpp'),$(filter %.cpp,$(SOURCES)))
lint: all
	@[ -z "$(LINT_FILES)" ] || clang-tidy -p $(BUILD) --quiet $(LINT_FILES)

# All fast suites under AddressSanitizer and UndefinedBehaviorSanitizer; then those that use threads most under
# ThreadSanitizer. sanitize-readers is the part that CI runs: the readers of files.
sanitize: deps
	cmake --preset sanitize
	cmake --build --preset sanitize --parallel $(JOBS)
	ctest --preset sanitize --parallel $(JOBS) --label-exclude slow
	cmake --preset tsan
	cmake --build --preset tsan --parallel $(JOBS) --target test_abi test_sim test_render_test
	scripts/run-suites build/tsan abi sim render_test

sanitize-readers: deps
	cmake --preset sanitize
	cmake --build --preset sanitize --parallel $(JOBS) --target test_guides
	scripts/run-suites build/sanitize guides

clean:
	rm -rf build out
