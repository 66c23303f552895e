# Everything a newcomer needs: `make paper` and `make test`.
PYTHON ?= python3
BIN := .venv/bin
READY := .venv/.ready

.PHONY: paper test test-slow lint format clean

paper: $(READY)  ## section IV of the paper: figures and the table of claims
	$(BIN)/clpt paper --out paper

test: $(READY)  ## every test but the slow ones
	$(BIN)/pytest -n 2

test-slow: $(READY)  ## the minutes-long tests
	$(BIN)/pytest -n 2 -m slow --no-header

lint: $(READY)  ## ruff and mypy
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

format: $(READY)
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

$(READY): pyproject.toml constraints.txt
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check \
		--constraint constraints.txt --editable ".[dev]"
	touch $@

clean:
	rm -rf .venv build dist paper out *.egg-info .pytest_cache .mypy_cache .ruff_cache
