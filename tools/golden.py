"""Keep the numbers that every command answers (tests/golden/answers), or list what differs from the kept ones.

python tools/golden.py            # list every difference above 1e-9, exit 1 if there is one
python tools/golden.py --write    # keep the numbers as they are now
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.golden.commands import FOLDER, answer, commands, differences, file_of

TOLERANCE = 1e-9


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--write", action="store_true", help="keep the numbers as they are now")
    parser.add_argument("--only", default="", help="commands that begin so")
    options = parser.parse_args()
    FOLDER.mkdir(exist_ok=True)
    wanted = [command for command in commands() if command.startswith(options.only)]
    changed = 0
    for command in wanted:
        file, now = file_of(command), answer(command)
        kept = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        lines = differences(kept, now, tolerance=TOLERANCE)
        changed += len(lines)
        if lines:
            print(f"{command}: {len(lines)} differ")
            print("\n".join(f"    {line}" for line in lines[:8]))
        if options.write and lines:
            file.write_text(json.dumps(now, indent=0) + "\n", encoding="utf-8")
    if options.write and not options.only:
        for stray in set(FOLDER.glob("*.json")) - {file_of(command) for command in wanted}:
            stray.unlink()
    return 1 if changed and not options.write else 0


if __name__ == "__main__":
    sys.exit(main())
