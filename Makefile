# Everything from a bare machine: only python3 (3.11 or newer) and make are needed.
VENV := .venv
BIN := $(VENV)/bin
UV := $(BIN)/uv
BAT := r161-ash
OUT := report
unexport PYTHONDONTWRITEBYTECODE  # what one run has compiled the next need not, nor each program that a test starts

.PHONY: report app browser test test-lowest quick-lowest coverage lint js types docs sbom pins mutants random-mutants evidence bench bench-quick format lock fuzz kills metamorphic house clean

report: $(VENV)/.run  ## where does this bat hit best? BAT=name or file, OUT=folder
	$(BIN)/sweetspot report $(BAT) --out $(OUT)

app: $(VENV)/.run  ## the laboratory in a browser
	$(BIN)/sweetspot app

browser:  ## Chromium for the page's tests, where apt-get may install it; the shell without windows needs less of the processor
	@command -v chromium-headless-shell > /dev/null && exit 0; \
	if [ "$$(id -u)" = 0 ] && command -v apt-get > /dev/null; then \
		export DEBIAN_FRONTEND=noninteractive; \
		timeout 60 apt-get update -qq && for name in chromium-headless-shell chromium; do \
			timeout 300 apt-get install -y -qq --no-install-recommends $$name > /dev/null && exit 0; done; fi; \
	for name in chromium chromium-browser google-chrome; do command -v $$name > /dev/null && exit 0; done; \
	echo "No Chromium here and none could be installed: tests of the page in a browser are skipped (with CI=true: fail)."

test: $(VENV)/.dev browser  ## all tests; three at a time keep two cores busy, as tests of the page wait for a browser
	$(BIN)/python -m pytest -q -n 3 --dist worksteal

LOWEST := .venv-lowest
UNDER_LOWEST := $(addprefix tests/,catalog collision dynamics equipment flight motion numerics units reports cli calibration)
QUICK_LOWEST := $(addprefix tests/,units motion equipment catalog/files collision/test_contact_law.py dynamics/test_bending.py \
	flight/test_trajectory.py cli/test_hostile_files.py calibration/outline/test_drawings.py cli/test_design_command.py \
	reports/drawings/test_drawing_files.py)

test-lowest: $(LOWEST)/.installed  ## tests of all but pages in a browser and fits with the lowest versions that pyproject allows
	$(LOWEST)/bin/python -m pytest -q $(UNDER_LOWEST) --ignore tests/reports/test_one_sheet.py \
		--ignore tests/calibration/test_other_code.py

quick-lowest: $(LOWEST)/.installed  ## a part of them, and a report; a minute
	$(LOWEST)/bin/python -m pytest -q $(QUICK_LOWEST)
	$(LOWEST)/bin/sweetspot report $(BAT) > /dev/null

# every branch of the physics at least once; what numba compiles is run as Python for it
PHYSICS := motion numerics equipment collision dynamics flight analysis calibration uncertainty
COVERED := $(addprefix src/sweetspot/,$(PHYSICS)) $(addprefix tests/,$(PHYSICS) catalog reports/test_notebook.py reports/uncertainty \
	$(patsubst %,cli/test_%_command.py,calibrate certify outline rank tap))
COVERED_AS_PYTHON := $(addprefix tests/,numerics/test_banded.py collision/test_kernel_agreement.py collision/test_time_history.py \
	collision/test_hit_convergence.py::test_a_bat_that_overtakes_the_ball_hits_it_again \
	dynamics/batch flight/test_kernel.py flight/test_fence.py flight/test_home_runs.py)
NOT_AS_PYTHON := not threads and not matter and not know and not error and not scatter and not drag and not 1000
WITH_COVERAGE := -q -p no:xdist --benchmark-disable --hypothesis-profile=few --cov --cov-append --cov-report=

coverage: $(VENV)/.dev  ## branches of the physics that its tests reach; fails below 95 in 100; minutes
	$(BIN)/coverage erase
	$(BIN)/python -m pytest $(WITH_COVERAGE) $(COVERED)
	NUMBA_DISABLE_JIT=1 $(BIN)/python -m pytest $(WITH_COVERAGE) -W ignore::RuntimeWarning $(COVERED_AS_PYTHON) \
		-k "$(NOT_AS_PYTHON)"
	$(BIN)/python tools/branches.py

lint: $(VENV)/.dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(VENV)/.dev
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

JS := src/sweetspot/web/static
UNREACHED := code (E(NOTFOUND|AI_AGAIN|CONNREFUSED|CONNRESET|TIMEDOUT|HOSTUNREACH|NETUNREACH|403|407|5[0-9][0-9])|ERR_SOCKET)

js: $(VENV)/.dev  ## types and rules of the page's JavaScript; Node comes as a wheel, the tools from npm
	$(BIN)/python tools/answer_types.py --check
	@if $(MAKE) -s --no-print-directory node_modules/.installed; then \
		$(BIN)/node node_modules/typescript/bin/tsc && $(BIN)/node node_modules/eslint/bin/eslint.js $(JS) && \
		echo "JavaScript checked: types and rules of $$(find $(JS) -name '*.js' | wc -l) modules"; \
	elif grep -qE '$(UNREACHED)' build/npm.log; then echo "The page's JavaScript is not checked: npm's packages cannot be reached from here."; \
	else exit 1; fi

types: $(VENV)/.dev
	$(BIN)/mypy

docs: $(VENV)/.dev  ## the documentation, warnings are errors
	$(BIN)/python -m sphinx -W --keep-going -q -b html docs docs/_build/html
	@echo "open docs/_build/html/index.html"

sbom: $(VENV)/.dev  ## build/sbom.cdx.json: everything that the pins bring, as CycloneDX
	@mkdir -p build
	$(BIN)/cyclonedx-py requirements requirements.txt --pyproject pyproject.toml --output-reproducible -o build/sbom.cdx.json

pins: $(VENV)/.dev  ## whether every promised Python and system can install the pinned versions as wheels
	$(BIN)/python tools/pins.py

mutants: $(VENV)/.dev  ## deliberate mistakes in physics and catalogue that the tests must notice; goes on where it stopped
	$(BIN)/python tools/mutants.py

random-mutants: $(VENV)/.dev  ## N mistakes at places chosen by chance (SEED) that the nearest tests must notice
	$(BIN)/python -m tools.random_mutants $(or $(N),50) --seed $(or $(SEED),1)

evidence: $(VENV)/.dev  ## which published rows notice a constant of the physics that is wrong; goes on where it stopped
	$(BIN)/python tools/evidence.py

kills: $(VENV)/.dev  ## kill -9 at random moments of season, design, calibrate and fit-player, and the same again: the same bytes
	$(BIN)/python tools/kills.py --runs $(or $(RUNS),500) --seed $(or $(SEED),1)

MANY := 100
metamorphic: $(VENV)/.dev  ## relations between answers on MANY times as many generated bats, flights and files as usual
	SWEETSPOT_EXAMPLES=$(MANY) $(BIN)/python -m pytest -q -n 2 --dist worksteal tests/metamorphic

fuzz: $(VENV)/.dev  ## a million generated inputs; goes on where it stopped, keeps what breaks something
	$(BIN)/python tools/fuzz.py

bench: $(VENV)/.dev browser  ## measured figures, beside rivals
	$(BIN)/python -m pytest benchmarks -q -p no:xdist --benchmark-only

bench-quick: $(VENV)/.dev browser
	SWEETSPOT_BENCH_QUICK=1 $(BIN)/python -m pytest benchmarks -q -p no:xdist --benchmark-only

golden: $(VENV)/.dev  ## keep the numbers that every command answers now; say why in the changelog
	$(BIN)/python tools/golden.py --write

house: $(VENV)/.dev  ## how much there is of what should be little, beside its goals
	$(BIN)/python tools/house.py

golden-check: $(VENV)/.dev  ## list numbers that changed by more than 1e-9
	$(BIN)/python tools/golden.py

LOCK = $(UV) pip compile -q --universal --python-version 3.11.0 --generate-hashes --no-header --no-annotate --no-emit-index-url

lock: $(UV)  ## pin the newest versions that pyproject allows, for every Python and platform from the lowest up
	$(LOCK) --upgrade --extra all pyproject.toml -o requirements.txt
	$(LOCK) --upgrade --extra dev -c requirements.txt pyproject.toml -o requirements-dev.txt
	echo uv | $(LOCK) --upgrade - -o requirements-uv.txt
	$(LOCK) --resolution lowest-direct --extra all --extra tests pyproject.toml -o requirements-lowest.txt

clean:
	rm -rf $(VENV) $(LOWEST) node_modules docs/_build docs/_generated docs/gallery build report .mypy_cache .ruff_cache .pytest_cache .benchmarks

$(UV):
	@python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
		|| { echo "sweetspot needs Python 3.11 or newer; python3 here is $$(python3 --version)"; exit 2; }
	@python3 -c 'import ensurepip, venv' 2> /dev/null \
		|| { echo "python3 here lacks venv with pip; on Debian or Ubuntu: sudo apt install python3-venv"; exit 2; }
	python3 -m venv $(VENV)
	$(BIN)/python -m pip install -q --disable-pip-version-check -r requirements-uv.txt

node_modules/.installed: package.json package-lock.json
	@mkdir -p build
	@NODE_USE_SYSTEM_CA=1 $(BIN)/npm ci --ignore-scripts --no-audit --no-fund --no-update-notifier > build/npm.log 2>&1 || { cat build/npm.log; exit 1; }
	@touch $@

$(LOWEST)/.installed: requirements-lowest.txt pyproject.toml | $(UV)
	test -d $(LOWEST) || python3 -m venv --without-pip $(LOWEST)
	VIRTUAL_ENV=$(LOWEST) $(UV) pip sync -q --only-binary :all: requirements-lowest.txt
	VIRTUAL_ENV=$(LOWEST) $(UV) pip install -q --no-deps -e .
	@touch $@

$(VENV)/.run: requirements.txt pyproject.toml | $(UV)
	$(UV) pip install -q --compile-bytecode -r requirements.txt
	$(UV) pip install -q --no-deps -e .
	$(BIN)/sweetspot prepare
	@touch $@

$(VENV)/.dev: requirements-dev.txt pyproject.toml | $(UV)
	$(UV) pip install -q --compile-bytecode -r requirements-dev.txt
	$(UV) pip install -q --no-deps -e .
	@touch $@ $(VENV)/.run
