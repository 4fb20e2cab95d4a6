"""`python -m sweetspot` is the command line."""

from sweetspot.cli import main

main()
