# A thin wrapper over CMake's presets. PRESET=dev|release|ci chooses one; JOBS how many compile at
# once.
PRESET ?= release
JOBS ?= $(shell nproc)
BUILD := build/$(PRESET)
LANCRET := $(BUILD)/tools/lancret
SOURCES := $(shell git ls-files '*.h' '*.cpp' 2>/dev/null)

.PHONY: all preview evaluate gallery blender-addon test test-slow bench format format-check lint deps clean

all: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET)
	cmake --build --preset $(PRESET) --parallel $(JOBS)

# Installs what is missing; says and does nothing where all is there.
deps:
	@scripts/install-deps

# The main job on a groom that Lancret makes by itself: its guides simulated, pictures of a turn of
# the head and a proof in out/.
preview: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF -DLANCRET_BENCH=OFF
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target lancret
	@mkdir -p out
	$(LANCRET) simulate examples/made_groom.toml --frames 1-24 -o out/cache.h5 --restart --stats out/simulate.json
	$(LANCRET) preview examples/made_groom.toml -o out/preview.png --stats out/preview.json
	$(LANCRET) preview out/cache.h5 --frames 9-13 --size 320x320 --samples 16 -o out/turn.####.png
	$(LANCRET) check out/cache.h5 --frames 9-13 --json out/check.json
	@echo "The pictures are out/preview.png and out/turn.*.png, the proof is out/check.json."

# Every blend on made grooms, straight to tightly curled: tables, figures and pictures in
# out/evaluate/. More grooms: make evaluate GROOMS="groom.hair other.toml".
GROOMS ?= $(wildcard examples/evaluate/*.toml)
evaluate: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF -DLANCRET_BENCH=OFF
	cmake --build --preset $(PRESET) --parallel $(JOBS) --target lancret
	@mkdir -p out/evaluate
	@set -e; for groom in $(GROOMS); do name=$$(basename $${groom%.*}); \
	  $(LANCRET) evaluate $$groom --json out/evaluate/$$name.json --image out/evaluate/$$name.png --size 240x300; \
	done

# What hair can look like: straight, wavy and tightly curled; brown, blond and black; fur, grass, a
# lens, fewer and wider strands, a turn of the head; in out/gallery/.
gallery: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF -DLANCRET_BENCH=OFF
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

# The Blender add-on with the Python package and the library, for Blender to install: docs/blender.md.
blender-addon: deps
	@[ -f $(BUILD)/build.ninja ] || cmake --preset $(PRESET) -DLANCRET_TESTS=OFF -DLANCRET_BENCH=OFF
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
	clang-format -i $(SOURCES)

format-check:
	clang-format --dry-run --Werror $(SOURCES)

lint: all
	clang-tidy -p $(BUILD) --quiet $(filter %.cpp,$(SOURCES))

clean:
	rm -rf build out
