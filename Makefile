# What there is to do here; `make help` lists it. Set-up is scripts/setup.sh, building is CMake's (CMakePresets.json).

.PHONY: help run test test-whole native measure mutation bench gallery format clean setup-% build-%
.NOTPARALLEL:

help:
	@echo "make run      build the browser version and serve it on this machine"
	@echo "make test     build all and run every test"
	@echo "make test-whole  run those that take long with all of their cameras and steps: an hour or more"
	@echo "make native   build the desktop program, build/native/terrella"
	@echo "make measure  measure what accuracy costs, and what holds at the extremes, as pages in build/measure"
	@echo "make mutation plant mistakes in the formulas and see which tests notice"
	@echo "make bench    measure speed, memory and size of both"
	@echo "make gallery  draw every preset for docs/gallery.md"
	@echo "make format   lay out the C++ files as .clang-format says"
	@echo "make clean    remove all that was built"
	@echo "Each installs first what it misses, by the system's package manager."

run: setup-web build-web
	@scripts/serve.sh build/web/dist

native: setup-native build-native

test: setup-test build-native build-sanitize build-web
	ctest --preset native
	ctest --preset sanitize
	@if [ -e tests/web/run.mjs ]; then $(MAKE) --no-print-directory test-web; fi

test-whole: setup-test build-native
	TERRELLA_WHOLE=1 ctest --preset native

measure: native
	build/native/terrella measure --out build/measure
	build/native/terrella measure --extremes --out build/measure/extremes

# In a copy under build/mutation; takes ten minutes or more, so it is no part of `make test`.
mutation: setup-native
	tests/mutation/run.sh

bench: setup-bench build-native build-web tests/web/node_modules/.package-lock.json
	build/native/bench/terrella_bench
	node bench/page_bench.mjs

gallery: native
	scripts/gallery.sh build/native/terrella

format: setup-format
	git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	rm -rf build

setup-%:
	@scripts/setup.sh $*

build-%: build/%/build.ninja
	@cmake --build --preset $*

# Once: later on, ninja sees by itself when it must be made anew.
build/%/build.ninja: CMakePresets.json
	cmake --preset $*
	@touch $@

.PRECIOUS: build/%/build.ninja

# The real page in a real browser.
.PHONY: test-web
test-web: tests/web/node_modules/.package-lock.json
	node tests/web/run.mjs

tests/web/node_modules/.package-lock.json: tests/web/package.json tests/web/package-lock.json
	cd tests/web && npm ci --no-audit --no-fund
	@touch $@
