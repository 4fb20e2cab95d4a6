"""Where one batter of a written season met the ball."""

from __future__ import annotations

from pathlib import Path

import polars as pl
import pytest

from sweetspot.errors import InputError
from sweetspot.seasons.ball_maps import contact_places
from sweetspot.units import INCH


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "balls").mkdir()
    for part, places in enumerate(([5.0, None], [7.0, 2.0])):
        table = pl.DataFrame({"batter": [7, 7] if part == 0 else [7, 9], "from_tip_in": places})
        table.write_parquet(tmp_path / "balls" / f"000{part}.parquet")
    return tmp_path


def test_the_medians_of_one_batter(folder: Path) -> None:
    assert contact_places(folder, "7") == pytest.approx([5 * INCH, 7 * INCH])


def test_who_is_not_there_is_told_in_a_line(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no place of a ball of the batter '8' is known"):
        contact_places(folder, "8")
    with pytest.raises(InputError, match=r"holds no balls/\*\.parquet"):
        contact_places(tmp_path / "nowhere", "7")
    pl.DataFrame({"batter": [7]}).write_parquet(folder / "balls" / "0000.parquet")
    (folder / "balls" / "0001.parquet").unlink()
    with pytest.raises(InputError, match="without --flight-only"):
        contact_places(folder, "7")
