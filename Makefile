# Everything a newcomer needs: `make paper` and `make test`.
PYTHON ?= python3
BIN := .venv/bin
READY := .venv/.ready

BENCH := build/benchmarks/venv
LOWEST := build/lowest
DIST := build/dist
SITE := .venv/.docs
USUAL := not (slow or processes or browser or board or coq)
ENGINE := tests/engine/codegen tests/engine/solver tests/engine/conformance \
	tests/ensemble/test_members.py tests/simulation/test_models_as_they_stand.py

unexport PYTHONDONTWRITEBYTECODE  # else each of the processes that tests start compiles the package

.PHONY: paper solver solver-check test test-long test-slow proofs test-processes test-board test-browser test-generic test-lowest lint format clean bench bench-quick dist try-wheel docs notebooks linkcheck

paper: $(READY)  ## section IV of the paper: figures and the table of claims
	$(BIN)/clpt paper --out paper

test: $(READY)  ## every test but the long and the slow ones
	OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist worksteal -m "not long and $(USUAL)"

test-long: $(READY)  ## proofs of many laws, and recipes: seconds each
	OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist worksteal --no-header \
		-m "long and $(USUAL)"

test-slow: $(READY)  ## the minutes-long tests
	OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist worksteal -m slow --no-header

proofs: $(READY)  ## compile the theorems in Coq, then files with altered signs: needs coqc and coqchk
	$(BIN)/clpt prove --coq build/coq
	OPENBLAS_NUM_THREADS=1 $(BIN)/python tools/check_proofs.py build/coq
	OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -m "coq and not long" --no-header \
		tests/theory/test_coq.py tests/theory/test_verdict_files.py \
		tests/theory/test_levels_under_inputs.py

test-processes: $(READY)  ## processes that are interrupted, killed and given full disks; `make test` has one of each kind
	OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist worksteal -m processes --no-header

test-browser: $(READY)  ## pages to send, the page of a replay and the site in headless Chromium, where one is installed
	OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -m browser -rs tests/browser

test-board: $(READY)  ## the learner on a Cortex-M7 in QEMU, where it and a compiler for Arm are installed
	OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -m board -rsP tests/simulation/test_on_board.py

test-generic: $(READY)  ## the engine's tests as on a processor without vector extensions
	CLPT_CONTROL_PROCESSOR=generic OPENBLAS_NUM_THREADS=1 $(BIN)/pytest -n 2 --dist worksteal \
		$(ENGINE)

test-lowest: $(LOWEST)/.ready  ## every test, with the lowest versions that pyproject.toml allows
	OPENBLAS_NUM_THREADS=1 $(LOWEST)/bin/python -m pytest -n 2 --dist worksteal

solver: $(READY)  ## print engine/solver/time_stepper.py and its imports as LLVM text, after a change of one
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt numba
	$(BIN)/python tools/print_solver.py

solver-check: $(READY)  ## print the solver anew, and compare it with the text that is there
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt numba
	$(BIN)/python tools/print_solver.py --check

lint: $(READY)  ## ruff, mypy and sizes
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/python tools/check_sizes.py

docs: $(SITE)  ## the site in build/docs: warnings are errors, notebooks run
	OPENBLAS_NUM_THREADS=1 $(BIN)/sphinx-build --fail-on-warning --keep-going --nitpicky --quiet \
		-d build/doctrees docs build/docs || { test -f build/docs/searchindex.js || rm -rf build/docs; exit 1; }

notebooks: $(SITE)  ## tutorials as notebooks with outputs, in build/tutorials
	OPENBLAS_NUM_THREADS=1 $(BIN)/python tools/write_notebooks.py

linkcheck: docs  ## every link and anchor of the site, in ten minutes
	$(BIN)/python .ci/follow_links.py

dist: $(DIST)/.ready  ## sdist and wheel into dist/, checked
	rm -rf dist
	$(DIST)/bin/python -m build --quiet
	$(DIST)/bin/twine check --strict dist/*
	$(DIST)/bin/check-wheel-contents dist/*.whl
	$(DIST)/bin/cffconvert --validate
	$(DIST)/bin/python .ci/check_dist.py

try-wheel: dist  ## the wheel alone, in a new environment and an empty folder
	$(PYTHON) -m venv --clear $(DIST)/alone
	$(DIST)/alone/bin/python -m pip install --quiet --disable-pip-version-check dist/*.whl
	PATH="$(CURDIR)/$(DIST)/alone/bin:$$PATH" .ci/try_wheel
	$(DIST)/alone/bin/python -m pip install --quiet --disable-pip-version-check "$$(echo dist/*.whl)[sea]"
	PATH="$(CURDIR)/$(DIST)/alone/bin:$$PATH" .ci/try_wheel sea

bench: $(BENCH)/.ready  ## time the engines against each other: docs/performance.md
	$(BENCH)/bin/python -m benchmarks.bench

bench-quick: $(READY)  ## the same in a minute or two, with what is installed
	$(BIN)/python -m benchmarks.bench --quick --out build/benchmarks

format: $(READY)
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

$(READY): pyproject.toml constraints.txt
	@echo "Making .venv and installing all parts: network, 1.1 GB, 1 to 3 minutes"
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --disable-pip-version-check \
		--constraint constraints.txt --editable ".[dev]"
	touch $@

$(SITE): $(READY)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check \
		--constraint constraints.txt --editable ".[docs]"
	touch $@

clean:
	rm -rf .venv build dist paper out *.egg-info .pytest_cache .mypy_cache .ruff_cache

$(BENCH)/.ready: pyproject.toml constraints.txt benchmarks/requirements.txt
	test -x $(BENCH)/bin/python || $(PYTHON) -m venv $(BENCH)
	$(BENCH)/bin/python -m pip install --quiet --disable-pip-version-check \
		--constraint constraints.txt --editable ".[all]"
	-$(BENCH)/bin/python -m pip install --quiet --disable-pip-version-check \
		--constraint constraints.txt --requirement benchmarks/requirements.txt
	touch $@

$(DIST)/.ready: Makefile
	test -x $(DIST)/bin/python || $(PYTHON) -m venv $(DIST)
	$(DIST)/bin/python -m pip install --quiet --disable-pip-version-check \
		build twine check-wheel-contents cffconvert py-rattler-build
	touch $@

$(LOWEST)/.ready: pyproject.toml
	$(PYTHON) -m venv --clear $(LOWEST)
	$(LOWEST)/bin/python -m pip install --quiet --disable-pip-version-check uv
	$(LOWEST)/bin/uv pip install --quiet --python $(LOWEST)/bin/python \
		--resolution lowest-direct --editable ".[test]"
	touch $@
