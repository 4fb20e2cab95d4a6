"""The command line: thin. Parses, calls the library, prints. Heavy imports happen inside the commands."""

from __future__ import annotations

import os
import sys

from sweetspot.errors import SweetspotError

EXIT_BAD_INPUT = 2


def main(arguments: list[str] | None = None) -> None:
    """Run the command line; exit 0 when done, 1 when a checked thing failed, 2 on bad input with one clear message."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # our matrices are small; threads only get in each other's way
    from cyclopts import CycloptsError

    from sweetspot.cli.app import app

    try:
        result = app(arguments, exit_on_error=False, print_error=False, result_action="return_value")
    except (SweetspotError, CycloptsError) as error:
        print(f"sweetspot: {_one_line(error)}", file=sys.stderr)
        sys.exit(EXIT_BAD_INPUT)
    except BrokenPipeError:
        sys.stderr.close()
        sys.exit(0)
    except KeyboardInterrupt:
        print("sweetspot: interrupted; nothing was written", file=sys.stderr)
        sys.exit(130)
    sys.exit(result if isinstance(result, int) else 0)


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split())
