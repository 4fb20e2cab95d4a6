"""The table of quantities as the page has it: what it shows of a stored number is what a reader is shown."""

from __future__ import annotations

import json

import pytest

from sweetspot.reports.quantities import SI, US, Reader, System
from sweetspot.reports.quantity_table import ENDINGS, quantity_data
from sweetspot.web.files import static_files
from sweetspot.web.views import VIEWS


@pytest.mark.parametrize(("system", "reading"), [("us", US), ("si", SI)])
@pytest.mark.parametrize(
    ("ending", "stored", "value", "scale"),
    [
        ("_mph", 90.0, 40.2336, "speed"),
        ("_m_s", 40.2336, 40.2336, "speed"),
        ("_in", 33.0, 0.8382, "length"),
        ("_degf", 68.0, 20.0, "temperature"),
        ("_degc", 20.0, 20.0, "temperature"),
        ("_inhg", 29.92, 29.92 * 3386.389, "pressure"),
        ("_kg_m2", 0.05, 0.05, "moi"),
        ("_rad", 0.5, 0.5, "angle"),
    ],
)
def test_a_stored_number_is_shown_as_readers_have_it(
    ending: str, stored: float, value: float, scale: str, system: System, reading: Reader
) -> None:
    row = quantity_data()["endings"][ending][system]
    shown = f"{stored * row['scale'] + row['offset']:.{row['digits']}f}"
    assert (shown, row["unit"]) == (reading.number(value, scale), reading.unit(scale))


def test_labels_are_words() -> None:
    """What a sport calls things is filled in: nobody reads "fastest {ball}"."""
    data = quantity_data()
    labels = [row["label"] for part in ("spots", "quantities") for row in data[part].values()]
    assert "fastest ball" in labels
    assert not [label for label in labels if "{" in label]


def test_longer_endings_come_first() -> None:
    """A name is looked up by the first ending that fits."""
    endings = list(ENDINGS)
    for place, ending in enumerate(endings):
        assert not any(later.endswith(ending) for later in endings[place + 1 :]), ending


def test_every_control_with_a_unit_has_an_ending() -> None:
    units = ("mph", "in", "ft", "oz", "degf", "deg", "rpm", "inhg", "pct", "ms")
    names = {name for view in VIEWS.values() for name in view.state.model_fields}
    assert all(f"_{name.rsplit('_', 1)[1]}" in ENDINGS for name in names if name.rsplit("_", 1)[-1] in units)


def test_the_page_has_it_as_a_module() -> None:
    text = static_files()["quantities.js"].content.decode()
    assert json.loads(text.removeprefix("export default ").rstrip(";\n")) == quantity_data()
