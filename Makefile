# Each target does its own set-up: an environment under build/, pinned packages, the native module.
#
#   make PYTHON=path          use this interpreter (3.11 or 3.13) instead of the first that runs
#   make demo GRID=path       touch this MOLA grid (.lbl or .img) instead of the synthetic sample
#   make bench GRID=path      measure on this MOLA grid of 4 pixels per degree too
#   make bench-contact-large KEEP=1    leave the large synthetic grids on the disk
#   make demo BLENDER=path    run the demo in this Blender (4.2 to 5.2) instead of the bpy module
#   make test ARGS='-k ...'   hand arguments to pytest
#   make bench-servo ARGS='--seconds 5'    measure lateness for less than 30 s by condition
#   make test-native PROPTEST_RNG_SEED=7    try the properties on other random cases
#   make test BPY=4.2.23      test with another release of the bpy module (one for this Python)

SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
MAKEFLAGS += --no-builtin-rules

PYTHON ?=
GRID ?=
BLENDER ?=
BPY ?=
KEEP ?=
ARGS ?=

ROOT := $(CURDIR)
BUILD := build

# Finding an interpreter means running candidates: only for goals that need one. In the person's own
# Blender (BLENDER=path) the demo needs Python for building only, so any release will do.
WITHOUT_PYTHON := help clean cargo test-native bench-contact-large
GOALS := $(or $(MAKECMDGOALS),help)
ifneq ($(filter-out $(WITHOUT_PYTHON),$(GOALS)),)
VERSIONS := 3.13 3.11$(if $(BLENDER), 3.14 3.12)
# A failed search leaves its one line in build/, to be shown by the rule that needs Python.
FOUND_PYTHON := $(if $(PYTHON),$(PYTHON),$(shell mkdir -p $(BUILD) && .ci/find-python $(VERSIONS) 2>$(BUILD)/no-python))
PYTHON_VERSION := $(if $(FOUND_PYTHON),$(shell "$(FOUND_PYTHON)" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null))
endif

VENV := $(BUILD)/venv-$(or $(PYTHON_VERSION),missing)$(if $(BLENDER),-blender)$(if $(BPY),-bpy-$(BPY))
BIN := $(VENV)/bin
PACKAGES := $(VENV)/packages.stamp
NATIVE := $(VENV)/native.stamp
SITE := $(BUILD)/site
SAMPLE := $(BUILD)/sample/sample.lbl
PACKAGE := $(BUILD)/package
BENCH := $(BUILD)/bench
MOLA := $(or $(GRID),../shared/data/mola/megt90n000cb.lbl)

NATIVE_SOURCES := $(shell find native \( -name target -o -name tests \) -prune -o -type f \
	\( -name '*.rs' -o -name 'Cargo.*' -o -name '*.toml' -o -name '*.pyi' -o -name py.typed \) -print)
ADDON_SOURCES := $(shell find addon -name __pycache__ -prune -o -name wheels -prune -o -type f -print 2>/dev/null)
PYTHON_CODE := $(wildcard .ci addon blender_scripts tests native/proxygraph)
TYPED_CODE := $(wildcard .ci/*.py addon blender_scripts tests)

# bpy reads and writes the configuration of the person who runs it, unless told where else.
export BLENDER_USER_RESOURCES := $(ROOT)/$(BUILD)/blender-user
# It also makes folders for thumbnails where caches are. Not exported: pip's cache stays where it is.
IN_BUILD := XDG_CACHE_HOME="$(BLENDER_USER_RESOURCES)/cache"
# Inside another environment pip and maturin would pick that one.
export VIRTUAL_ENV := $(ROOT)/$(VENV)
unexport PYTHONPATH PYTHONHOME

.PHONY: help
help: ## Show what can be made
	@echo "Haptic Terrain: touch planetary terrain in Blender"
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-20s %s\n", $$1, $$2 }' Makefile
	@echo "Options: PYTHON=path, GRID=path for demo and bench, KEEP=1 for bench-contact-large, BLENDER=path for demo, ARGS='...' for test and bench-servo, BPY=version."

# ---------------------------------------------------------------- set-up

.PHONY: venv
venv: $(PACKAGES) ## Make the virtual environment with its pinned packages

$(PACKAGES): pyproject.toml .ci/debian-packages
	@test -n "$(FOUND_PYTHON)" || { cat $(BUILD)/no-python >&2; exit 1; }
	@case "$(PYTHON_VERSION)" in \
		3.11|3.13) ;; \
		3.1[2-9]) test -n "$(BLENDER)" || { \
			echo "Missing: Python 3.11 or 3.13; $(FOUND_PYTHON) is $(PYTHON_VERSION), and bpy does not exist for it." >&2; exit 1; } ;; \
		"") echo "Missing: Python 3.11 or 3.13; $(FOUND_PYTHON) does not run." >&2; exit 1 ;; \
		*) echo "Missing: Python 3.11 or 3.13; $(FOUND_PYTHON) is $(PYTHON_VERSION)." >&2; exit 1 ;; \
	esac
	@echo "Making $(VENV)"
	@"$(FOUND_PYTHON)" -m venv $(VENV)
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check pip==26.3
	@$(BIN)/python -m pip install --quiet --group $(if $(BLENDER),build,develop)
	@$(if $(BPY),$(BIN)/python -m pip install --quiet bpy==$(BPY))
	@$(if $(BLENDER),,$(IN_BUILD) $(BIN)/python -c 'import bpy' 2>$(BUILD)/no-bpy || { \
		echo "Missing: system libraries that bpy loads ($$(tail -n 1 $(BUILD)/no-bpy)); on Debian:" \
			"apt-get install $$(tr '\n' ' ' < .ci/debian-packages)" >&2; exit 1; })
	@touch $@

.PHONY: cargo
cargo:
	@cargo --version >/dev/null 2>&1 || { echo "Missing: Rust (cargo); install a stable toolchain." >&2; exit 1; }

.PHONY: blender
blender:
	@"$(BLENDER)" --version >/dev/null 2>&1 || { echo "Missing: Blender; $(BLENDER) does not run." >&2; exit 1; }

.PHONY: native
native: $(NATIVE) ## Build the native module into the environment

$(NATIVE): $(PACKAGES) $(NATIVE_SOURCES) | cargo
	@echo "Building proxygraph"
	@$(BIN)/maturin develop --quiet --release --manifest-path native/proxygraph/Cargo.toml
	@touch $@

.PHONY: sample
sample: $(SAMPLE) ## Write the synthetic sample grid

$(SAMPLE): blender_scripts/make_sample_grid.py $(wildcard blender_scripts/sample_grid/*.py) | $(PACKAGES)
	@$(BIN)/python blender_scripts/make_sample_grid.py --output $(dir $@)

# ---------------------------------------------------------------- what people run

.PHONY: demo
ifeq ($(BLENDER),)
demo: cargo $(NATIVE) $(SAMPLE) ## Touch a grid, live and headless: picture, .blend and figures in build/demo
	@$(IN_BUILD) $(BIN)/python blender_scripts/demo.py --grid "$(or $(GRID),$(SAMPLE))" --output $(BUILD)/demo
else
demo: cargo blender $(SITE)/site.stamp
	@$(IN_BUILD) "$(BLENDER)" --background --factory-startup --python-exit-code 1 --python blender_scripts/demo.py -- \
		--site $(SITE) $(if $(GRID),--grid "$(GRID)") --output $(BUILD)/demo
endif

# What the person's own Blender lacks, unpacked: one wheel serves every Python from 3.11 on.
$(SITE)/site.stamp: $(PACKAGES) $(NATIVE_SOURCES) | cargo
	@echo "Building proxygraph for $(BLENDER)"
	@rm -rf $(SITE) $(BUILD)/site-wheels
	@$(BIN)/maturin build --quiet --release --manifest-path native/proxygraph/Cargo.toml --out $(BUILD)/site-wheels \
		--interpreter "$(ROOT)/$(BIN)/python"
	@$(BIN)/python -m pip install --quiet --no-deps --target $(SITE) $(BUILD)/site-wheels/*.whl
	@$(BIN)/python -m pip install --quiet --target $(SITE) --group blender
	@touch $@

.PHONY: rover
rover: cargo $(NATIVE) $(SAMPLE) ## Render a rover that follows the ground, and feels it: build/rover
	@$(IN_BUILD) $(BIN)/python blender_scripts/rover.py --output $(BUILD)/rover

.PHONY: test
test: test-native test-python ## Run every test

.PHONY: test-python
test-python: cargo $(NATIVE) $(SAMPLE) ## Run the Python tests: native module, add-on, build
	@$(IN_BUILD) $(BIN)/python -m pytest $(ARGS)

# Debian's Blender in a folder outside this one, made once: not in the cache that IN_BUILD names.
.PHONY: test-gui
test-gui: cargo $(PACKAGE)/package.stamp ## Play scenarios in a real Blender window on a screen in memory: build/gui
	@mkdir -p $(BENCH)
	@$(BIN)/python -m pytest tests/gui $(ARGS)
	@$(BIN)/python tests/bench/measure_window.py $(BENCH)/gui.json --package $(PACKAGE)

# The same random cases every time, so that a change that fails is a change that broke something.
export PROPTEST_RNG_SEED ?= 2003

.PHONY: test-native
test-native: cargo ## Run the Rust tests
	@cargo test --quiet --manifest-path native/Cargo.toml --workspace

.PHONY: lint
lint: $(PACKAGES) | cargo ## Check formatting, lints and types
	@cargo fmt --version >/dev/null 2>&1 || { echo "Missing: rustfmt; rustup component add rustfmt" >&2; exit 1; }
	@cargo clippy --version >/dev/null 2>&1 || { echo "Missing: clippy; rustup component add clippy" >&2; exit 1; }
	cargo fmt --manifest-path native/Cargo.toml --all --check
	cargo clippy --quiet --manifest-path native/Cargo.toml --workspace --all-targets -- -D warnings
	$(BIN)/ruff check $(PYTHON_CODE)
	$(BIN)/ruff format --check $(PYTHON_CODE)
	$(BIN)/mypy $(TYPED_CODE)

.PHONY: format
format: $(PACKAGES) | cargo ## Format all code in place
	@cargo fmt --manifest-path native/Cargo.toml --all
	@$(BIN)/ruff check --quiet --fix $(PYTHON_CODE)
	@$(BIN)/ruff format --quiet $(PYTHON_CODE)

.PHONY: bench
bench: bench-contact bench-servo bench-formats bench-interface bench-recording ## Run every bench: tables, pictures and figures in build/bench

# The same release profile as the wheel's, and as little of the processor.
CONTACT_BENCH := cargo run --quiet --release --manifest-path native/Cargo.toml --package contact_bench --

.PHONY: bench-contact
bench-contact: cargo $(PACKAGES) ## Measure contact models on 33 and 133 million triangles: speed against accuracy
	@mkdir -p $(BENCH)
	@$(CONTACT_BENCH) --output $(BENCH) --mola "$(MOLA)"
	@$(BIN)/python tests/bench/draw_frontier.py $(BENCH)/contact.json $(BENCH)/frontier.png

.PHONY: bench-contact-large
bench-contact-large: cargo ## The same walk on 2 and 10 thousand million triangles: 12 GB on the disk meanwhile
	@mkdir -p $(BENCH)
	@$(CONTACT_BENCH) --large $(if $(KEEP),--keep) --output $(BENCH)

.PHONY: bench-servo
bench-servo: cargo $(PACKAGES) ## Measure the servo: stability in closed loop, faults, load, lateness
	@mkdir -p $(BENCH)
	@cargo run --quiet --release --manifest-path native/Cargo.toml --package servo_bench -- --output $(BENCH) \
		--mesh "$(BIN)/python tests/bench/build_meshes.py" $(ARGS)
	@$(BIN)/python tests/bench/draw_stability.py $(BENCH)/servo.json $(BENCH)/stability.png

# GDAL comes with rasterio, which nothing else needs.
.PHONY: bench-formats
bench-formats: cargo $(NATIVE) ## Measure the readers of elevation files beside GDAL, and fuzz them
	@mkdir -p $(BENCH)
	@$(BIN)/python -m pip install --quiet --group rasterio
	@$(IN_BUILD) $(BIN)/python tests/bench/measure_formats.py $(BENCH)/formats.json --data ../shared/data $(ARGS)

.PHONY: bench-interface
bench-interface: cargo $(NATIVE) $(SAMPLE) ## Measure the interface in Blender: timer, overlay, preview, forces at mode changes
	@mkdir -p $(BENCH)
	@$(IN_BUILD) $(BIN)/python tests/bench/measure_interface.py $(BENCH)/interface.json \
		--grid "$(or $(wildcard $(MOLA)),$(SAMPLE))"

.PHONY: bench-recording
bench-recording: cargo $(NATIVE) $(SAMPLE) ## Measure recording, F-curves of takes and baking
	@mkdir -p $(BENCH)
	@$(IN_BUILD) $(BIN)/python tests/bench/measure_recording.py $(BENCH)/recording.json

# ---------------------------------------------------------------- the extension

.PHONY: package
package: cargo $(PACKAGE)/package.stamp ## Build the extension's zip with its wheels

$(PACKAGE)/package.stamp: $(PACKAGES) $(NATIVE_SOURCES) $(ADDON_SOURCES) .ci/package .ci/complete_manifest.py \
		.ci/write_notices.py $(wildcard .ci/licences/*) | cargo
	@$(BIN)/python -m pip install --quiet --group package
	@.ci/package "$(BIN)" "$(PACKAGE)"
	@touch $@

# A bpy of its own, without anything that the zip should bring. Each release demands one Python.
MATRIX := 4.2.23 4.5.15 5.0.1 5.2.3
# Not what only reads the sources, whatever Blender there is.
MATRIX_TESTS := tests/addon tests/installed \
	--deselect tests/addon/test_extension.py::test_own_modules_are_imported_relatively \
	--deselect tests/addon/test_extension.py::test_formats_know_no_blender

.PHONY: test-matrix
test-matrix: $(MATRIX:%=test-installed-%) ## Run the add-on's tests on the installed zip, in each Blender

test-installed-%: cargo $(PACKAGE)/package.stamp $(BUILD)/matrix/bpy-%/packages.stamp
	@echo "The installed zip in Blender $*"
	@HAPTIC_TERRAIN_ZIP="$$(ls $(ROOT)/$(PACKAGE)/*.zip)" $(BUILD)/matrix/bpy-$*/bin/python -m pytest --quiet $(MATRIX_TESTS) $(ARGS)

# Else make takes it for something between and removes it.
.PRECIOUS: $(BUILD)/matrix/bpy-%/packages.stamp
$(BUILD)/matrix/bpy-%/packages.stamp: pyproject.toml
	@echo "Making $(@D)"
	@"$$(.ci/find-python $(if $(filter 5.2%,$*),3.13,3.11))" -m venv $(@D)
	@$(@D)/bin/python -m pip install --quiet --disable-pip-version-check pip==26.3
	@$(@D)/bin/python -m pip install --quiet --group installed bpy==$*
	@touch $@

.PHONY: clean
clean: ## Remove everything that was made
	rm -rf $(BUILD) native/target
