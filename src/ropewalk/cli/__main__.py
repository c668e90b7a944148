"""`python -m ropewalk.cli`, the same as `ropewalk`."""

from ropewalk.cli.app import main

main()
