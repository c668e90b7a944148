# Ropewalk: `make help` lists what can be made.
SHELL := /bin/bash
PYTHON ?= python3
BIN := .venv/bin
PYTEST := $(BIN)/python -m pytest
# a file's tests in one process, as many processes as there are cores
SPREAD := -n logical --dist loadfile

.DEFAULT_GOAL := help
.PHONY: help venv runtime dev demo view test test-all test-browser test-slow test-uncompiled lint locks format bench work-precision docs dist report page page-check clean distclean

help:  ## list the targets
	@grep -hE '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/:.*## /\t/' | \
	  awk -F '\t' '{printf "  make %-14s %s\n", $$1, $$2}'

venv:
	@command -v "$(PYTHON)" >/dev/null || { \
	  echo "make: there is no '$(PYTHON)'; Ropewalk needs Python 3.11 or newer." \
	       "Name one: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	  echo "make: Ropewalk needs Python 3.11 or newer; '$(PYTHON)' is $$($(PYTHON) -V 2>&1)." \
	       "Name another one: make PYTHON=python3.12" >&2; exit 1; }
	@if [ "$$(cat .venv/made-in 2>/dev/null || pwd)" != "$$(pwd)" ]; then \
	  echo "this folder was moved: making .venv anew"; rm -rf .venv; fi
	@$(BIN)/python -c 'import sys, pip; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
	  echo "making .venv with $$($(PYTHON) -V)"; \
	  $(PYTHON) -m venv --clear .venv || { rm -rf .venv; \
	  echo "make: no virtual environment could be made; on Debian and Ubuntu: apt install python3-venv" >&2; \
	  exit 1; }; }
	@pwd > .venv/made-in

# Installs only what the lock and the package's description say is new: a copy of both is kept in .venv.
# Every file is checked against the hash that requirements/PYTHON has of it (requirements/lock writes those).
define install
	@lock="requirements/$$($(BIN)/python -c 'import sys; print("%d.%d" % sys.version_info[:2])')/$(1).txt"; \
	[ -f "$$lock" ] || { \
	  echo "make: there is no $$lock; the locks are for Python $$(cd requirements && echo 3.*)." \
	       "Name one of these: make distclean, then make PYTHON=python3.12" >&2; exit 1; }; \
	cmp -s "$$lock" .venv/lock-$(1).txt || { \
	  echo "installing $$lock into .venv"; rm -f .venv/lock-$(1).txt; \
	  $(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r "$$lock" && \
	  cp "$$lock" .venv/lock-$(1).txt; }
endef

runtime: venv
	$(call install,demo)
	@cmp -s pyproject.toml .venv/installed.toml || { rm -f .venv/installed.toml; \
	  $(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps \
	    --no-build-isolation -e . && cp pyproject.toml .venv/installed.toml; }

dev: runtime
	$(call install,dev)

demo: runtime  ## set up, run the three-anchor rope of the report, print its results
	@$(BIN)/ropewalk demo

view: runtime  ## set up, show the three-anchor rope live in the browser
	@$(BIN)/ropewalk view

test: lint  ## set up, check the style, types and imports, run the tests (not slow or browser ones)
	$(PYTEST) $(SPREAD) -m "not slow and not browser"

test-all: dev  ## run all tests but the browser's
	$(PYTEST) $(SPREAD) -m "not browser"

test-browser: dev  ## drive the live page and shared pages in a real Chromium
	$(PYTEST) -m browser tests/browser

test-slow: dev  ## run the slow tests
	$(PYTEST) $(SPREAD) -m "slow and not browser"

# Numba reads the option, so nothing is compiled and no cache is asked.
UNCOMPILED := tests/verification/test_tangent.py tests/verification/test_bending_tangent.py \
  tests/unit/test_saddle.py tests/verification/test_constant_forces.py tests/verification/test_laws.py \
  tests/verification/test_free_fall.py
test-uncompiled: dev  ## run tests of laws, tangents and the solver as plain Python, with coverage of the kernels
	NUMBA_DISABLE_JIT=1 $(PYTEST) -q -n logical -m "not slow" $(UNCOMPILED) --cov-report=term:skip-covered \
	  --cov=ropewalk.core --cov=ropewalk.laws --cov=ropewalk.methods

lint: dev  ## check style, format, types and the import contracts
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-logo

locks:  ## write requirements/PYTHON anew, for Python 3.11 to 3.14, after a change of pyproject.toml
	PYTHON="$(PYTHON)" requirements/lock

format: dev  ## put the code into the common format
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

bench: dev  ## measure the speed, and error against time: tables, figures, CSV (an hour)
	$(BIN)/python -m bench

work-precision: dev  ## only error against time of all methods, numpy and scipy
	$(BIN)/python -m bench work_precision

docs: dev  ## build the documentation as a site in docs/_build/html
	$(BIN)/sphinx-build -q -W --keep-going -n -b html docs docs/_build/html
	@echo "docs/_build/html/index.html"

dist: dev  ## build wheel and source archive into dist/, and check them
	rm -rf dist
	$(BIN)/python -m hatchling build -d dist
	$(PYTEST) -q tests/architecture/test_dist.py

report: runtime  ## check the claims of the student report: one page with figures
	$(BIN)/ropewalk report

page/node_modules/.package-lock.json: page/package-lock.json
	@command -v npm >/dev/null || { \
	  echo "make: there is no npm; on Debian and Ubuntu: apt install nodejs npm" >&2; exit 1; }
	cd page && npm ci --no-audit --no-fund
	@touch $@

page: page/node_modules/.package-lock.json  ## bundle the live view's page from page/ (needs Node)
	cd page && npm run --silent build

page-check: page/node_modules/.package-lock.json  ## check the page: format, types, tests, whether the bundle is fresh
	cd page && npm run --silent check

clean:  ## remove what was built and cached, keep .venv and runs
	rm -rf docs/_build .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache build dist
	find src tests docs bench examples -name __pycache__ -type d -prune -exec rm -rf {} + 2>/dev/null || true

distclean: clean  ## remove .venv and Node's packages as well
	rm -rf .venv page/node_modules
