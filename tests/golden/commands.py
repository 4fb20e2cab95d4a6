"""The commands whose numbers are kept, and how an answer becomes a short table of numbers."""

from __future__ import annotations

import contextlib
import io
import json
import math
import os
import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command line does; sums in another order round otherwise

from sweetspot import catalog
from sweetspot.cli import main

FOLDER = Path(__file__).parent / "answers"
KEPT_OF_A_LIST = 7
"""A longer list is known by its length and as many of its members, the first and the last among them."""

Answer = dict[str, float | str | bool | None]


def commands() -> tuple[str, ...]:
    """Return every command line whose answer is kept, without ``--format json``."""
    bats, implements = catalog.bat_names(), catalog.implement_names()
    return (
        *(f"report {name}" for name in implements),
        *(f"hit {name} --at 15cm-from-tip" for name in ("r161-ash", "single-wall", "tennis-racket", "hockey-stick")),
        "hit tennis-racket --at 20cm-from-tip --beside 3cm",
        "compare r161-ash russell-b6 single-wall",
        "compare r161-ash --what-if cork",
        "compare r161-ash --rows mass=29oz:33oz:3 --columns bore-depth=0in:12in:3",
        "compare tennis-racket badminton-racket --force",
        *(f"certify {name}" for name in bats),
        "certify russell-b6 --league all",
        "play",
        "play --pitch curve --offset 0.9in --park fenway --wind-speed 8mph --bats left",
        "play single-wall --at 4in-from-tip --bat-speed 75mph --park coors --attack-angle 14deg",
        "fly",
        "fly --park coors --exit-speed 104mph --launch-angle 31deg --spray -22deg --wind-speed 10mph",
        "fly --exit-speed 90mph:110mph:3 --launch-angle 15deg:40deg:3",
        "fly --ball tennis --exit-speed 30m/s --launch-angle 8deg --height 1m",
        "optimum --show launch",
        "optimum --show parks --park all",
        "optimum --show swing --pitch curve --at 6in-from-tip --attack-angle 10deg",
        "drop --height 1m",
        "drop --material aluminium-7xxx --thickness 5mm --support clamped --speed 60mph",
        "drop --ball tennis --height 254cm --in-air",
        "paper",
        "sports",
        *(f"sports {name}" for name in catalog.sport_names()),
        "parks",
        "parks coors",
        "bats",
        "pendulum --mass 30.5oz --balance-point 22.4in --period 1.38s",
        "kit r161-ash",
        "kit golf-driver --pieces 3",
        "plan-swings r161-ash mlb-a",
        "plan-swings r161-ash --find position --within 0.4in",
        "validate",
    )


def file_of(command: str) -> Path:
    """Return where the answer of a command is kept."""
    words = [word.lstrip("-").replace("/", "-").replace(":", "-").replace("=", "-") for word in shlex.split(command)]
    return FOLDER / f"{'_'.join(words)}.json"


def answer(command: str) -> Answer:
    """Run a command and return what it says, one entry a number or a word."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.suppress(SystemExit):
        main([*shlex.split(command), "--format", "json"])
    told = json.loads(printed.getvalue())
    told.pop("made_with")  # the commit is another every time
    if command == "validate":  # rows come and go: each is known by what it compares
        told = {f"{row['source']} {row['quantity']} {row['name']}": row["computed"] for row in told["rows"]}
    return dict(_entries("", told))


def differences(kept: Answer, now: Answer, *, tolerance: float) -> list[str]:
    """Return one line for each entry that came, went or changed by more than ``tolerance`` of its value."""
    lines = [f"{name}: gone (was {kept[name]})" for name in kept if name not in now]
    lines += [f"{name}: new ({now[name]})" for name in now if name not in kept]
    for name in kept.keys() & now.keys():
        before, after = kept[name], now[name]
        if isinstance(before, float) and isinstance(after, float):
            same = math.isclose(before, after, rel_tol=tolerance, abs_tol=1e-3 * tolerance)
        else:
            same = before == after
        if not same:
            lines.append(f"{name}: {before} -> {after}")
    return sorted(lines)


def _entries(name: str, value: Any) -> Iterator[tuple[str, float | str | bool | None]]:
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from _entries(f"{name}.{key}" if name else key, inner)
    elif isinstance(value, list):
        places = list(range(len(value)))
        if len(value) > KEPT_OF_A_LIST and not isinstance(value[0], dict):
            yield f"{name}.length", float(len(value))
            places = sorted({round(step * (len(value) - 1) / (KEPT_OF_A_LIST - 1)) for step in range(KEPT_OF_A_LIST)})
        for place in places:
            yield from _entries(f"{name}[{place}]", value[place])
    elif isinstance(value, bool) or value is None:
        yield name, value
    elif isinstance(value, (int, float)):
        yield name, float(value)
    elif not name.endswith(("comment", "reason", "note")):  # prose may be put better
        yield name, str(value)
