"""The views of the page, in the order of its navigation.

How to write one, say ``modes``:

* ``web/views/modes.py``: a state model (a `BatState` or `HitState` with more fields, or a `ViewState`; every field has
  bounds, a unit in its name and a default), ``answer(state) -> ModesAnswer``, a frozen dataclass as `answers.records`
  describes it, and ``VIEW = View("modes", "Modes", ModesState, answer)``. ``tools/answer_types.py`` writes its
  type for JavaScript: ``@type {View<"modes">}``.
  Take the bat from `web.bats`: ``reduced(state, ball)`` keeps beam and modes between requests, ``conditions_of(state,
  bat)`` gives pitch, swing, hands and ball. A control that does not work raises `FieldError(field, message)`, or wraps
  what fails in ``with about(field):``. An answer should take a few ms: 50 browsers may be dragging at once. What takes
  longer is an aside: ``View(..., asides={"fit": fit})``, asked for by ``app.aside`` once the controls rest. A document
  of `report` becomes one by `web.documents.page_document`; ``static/controls/document.js`` shows it. Lines to copy:
  ``recipe``.
* add it to a group of `GROUPS` below; the routes ``/modes``, ``POST /api/v1/modes`` and the socket then exist.
* ``web/static/views/modes.js``: see the notes at the top of ``web/static/shell/main.js``.
* ``tests/web/test_view_modes.py``: the answer without a browser, and with the fixture ``page`` (see
  ``tests/web/conftest.py``) what a person sees.
"""

from __future__ import annotations

from sweetspot.web.view import View
from sweetspot.web.views import (
    compare,
    design,
    explorer,
    flight,
    hit,
    modes,
    optimum,
    own,
    paper,
    player,
    season,
    sports,
    start,
)

GROUPS = {
    "My bat": (explorer, hit, modes, own),
    "Which bat": (compare, design, player),
    "The ball": (flight, optimum, season),
    "Learn": (paper, sports),
}
"""The views by what people want, as the bar has them."""
ORDER = (start, *(view for views in GROUPS.values() for view in views))
VIEWS: dict[str, View] = {view.VIEW.name: view.VIEW for view in ORDER}
GROUP_OF = {view.VIEW.name: group for group, views in GROUPS.items() for view in views}
