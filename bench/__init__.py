"""Benchmarks: `make bench`, or `python -m bench`. Ratios within one run; nothing here is a test."""
