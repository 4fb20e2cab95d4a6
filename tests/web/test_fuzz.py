"""Anything a program may send within the described API, and beside it: never a 5xx, always what is described."""

from __future__ import annotations

from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, given, settings
from schemathesis import Case
from schemathesis.checks import not_a_server_error
from schemathesis.core.result import Ok
from schemathesis.generation import GenerationMode
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_schema_conformance,
    status_code_conformance,
)

from sweetspot.web.server import create_app
from sweetspot.web.views import VIEWS

CHECKS = [not_a_server_error, status_code_conformance, content_type_conformance, response_schema_conformance]
EXAMPLES = 3
"""Of each operation; `make fuzz` tries a million."""
SLOW = ("fit", "sure", "rules_sure", "describe", "parks", "maps")
"""What takes longest; one example less of it."""


@pytest.mark.parametrize("mode", list(GenerationMode))
def test_no_example_breaks_the_server(mode: GenerationMode) -> None:
    schema = schemathesis.openapi.from_asgi("/api/v1/openapi.json", create_app())
    operations = [found.ok() for found in schema.get_all_operations() if isinstance(found, Ok)]
    assert {f"/api/v1/{name}" for name in VIEWS} <= {operation.path for operation in operations}
    for operation in operations:
        if mode is GenerationMode.NEGATIVE and operation.method == "get":
            continue  # takes nothing that could be wrong

        @settings(
            max_examples=2 if operation.path.endswith(SLOW) and mode is GenerationMode.POSITIVE else EXAMPLES,
            derandomize=True,
            database=None,
            phases=(Phase.generate,),
            suppress_health_check=list(HealthCheck),
        )
        @given(case=operation.as_strategy(generation_mode=mode))
        def check(case: Case[Any]) -> None:
            case.call_and_validate(checks=CHECKS, timeout=600)

        check()
