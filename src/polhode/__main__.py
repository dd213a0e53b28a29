"""Runs the command as ``python -m polhode``."""

from polhode.cli.main import main

if __name__ == "__main__":
    main()
