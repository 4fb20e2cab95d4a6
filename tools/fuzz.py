"""Feed generated inputs to everything that reads what people write, until a number of them is done.

    python tools/fuzz.py [--count N] [--kind KIND]

The inputs are those of tests/fuzz/generators.py, one after the other by number, so a run that is broken off goes on
where it stopped (build/fuzz.json). An input that crashes, hangs or gives a number that is none is made as small as it
can be while it still does, and kept in tests/fuzz/corpus, which the tests read. Exit 1 when something was found.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from sweetspot.errors import InputError  # noqa: E402
from tests.fuzz.generators import KINDS, text_of  # noqa: E402

STATE, CORPUS = ROOT / "build" / "fuzz.json", ROOT / "tests" / "fuzz" / "corpus"
MILLION = 1_000_000
BLOCK = 500
SLOWEST = 10.0
"""s of the processor for one input."""
PATIENCE = 60.0
"""s for making one input smaller."""


def fault(kind: str, text: str) -> str:
    """Return what is wrong with how an input is taken, or an empty text."""
    start = time.process_time()
    try:
        KINDS[kind].take(text)
    except InputError:
        pass
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return "slow" if time.process_time() - start > SLOWEST else ""


def smallest(text: str, still: Callable[[str], bool]) -> str:
    """Return a shorter text for which ``still`` holds: ever smaller pieces are left out as long as it does.

    >>> smallest("some bug in a haystack", lambda text: "bug" in text)
    'bug'
    """
    end = time.monotonic() + PATIENCE
    size = len(text) // 2
    while size:
        at = 0
        while at < len(text) and time.monotonic() < end:
            shorter = text[:at] + text[at + size :]
            text, at = (shorter, at) if still(shorter) else (text, at + size)
        size //= 2
    return text


def keep(kind: str, text: str, what: str) -> None:
    """Write an input into the corpus, made small while it fails in the same way."""
    kept = smallest(text, lambda shorter: fault(kind, shorter).partition(":")[0] == what.partition(":")[0])
    name = f"{kind}-{hashlib.blake2b(kept.encode(), digest_size=4).hexdigest()}.json"
    (CORPUS / name).write_text(json.dumps({"kind": kind, "text": kept, "was": what[:200]}) + "\n", encoding="utf-8")
    print(f"{kind}: {what[:100]}; kept as {name}")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=MILLION, help="inputs in all, over all kinds")
    parser.add_argument("--kind", choices=list(KINDS), help="this kind only")
    options = parser.parse_args()
    kinds = [options.kind] if options.kind else list(KINDS)
    done: dict[str, int] = json.loads(STATE.read_text(encoding="utf-8")) if STATE.exists() else {}
    STATE.parent.mkdir(exist_ok=True)
    seen: set[str] = set()
    while any(done.get(kind, 0) < options.count // len(kinds) for kind in kinds):
        for kind in kinds:
            first = done.get(kind, 0)
            for number in range(first, first + BLOCK):
                what = fault(kind, text_of(kind, number))
                if what and what[:60] not in seen:
                    seen.add(what[:60])
                    keep(kind, text_of(kind, number), what)
            done[kind] = first + BLOCK
            STATE.write_text(json.dumps(done), encoding="utf-8")
        print(" ".join(f"{kind} {done[kind]}" for kind in kinds), file=sys.stderr)
    return 1 if seen else 0


if __name__ == "__main__":
    sys.exit(main())
