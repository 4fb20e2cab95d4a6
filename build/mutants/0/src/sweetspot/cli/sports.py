"""The command `sports`: what is known of each sport, and how sure."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from sweetspot.cli.options import Format

if TYPE_CHECKING:
    from sweetspot.sport import Known, Sport

OutputFormat = Annotated[Format, Parameter(name="--format", help="table for people, json or csv for programs.")]


def sports(
    name: Annotated[str | None, Parameter(help="One sport in full; without it, all of them.")] = None,
    /,
    *,
    format: OutputFormat = "table",
) -> None:
    """List the sports with their balls, implements, speeds and rules, and how sure each number is."""
    if name is None:
        _all(format)
    else:
        _one(name, format)


def _all(format: Format) -> None:
    from sweetspot.catalog.sports import certainty, sport, sport_names
    from sweetspot.cli.output import print_json, print_rows_csv, print_table

    rows = [_summary(sport(name), certainty(name)) for name in sport_names()]
    if format == "json":
        print_json({"sports": rows})
    elif format == "csv":
        print_rows_csv([{**row, **{key: " ".join(row[key]) for key in ("balls", "implements")}} for row in rows])
    else:
        from sweetspot.report.sports import sports_table

        print_table(sports_table(rows))


def _summary(sport: Sport, counts: dict[Any, int]) -> dict[str, Any]:
    stroke = sport.stroke
    return {
        "key": sport.key,
        "name": sport.name,
        "balls": list(sport.balls),
        "implements": list(sport.implements),
        "swing_speed_m_s": stroke.swing_speed.value,
        "swing_speed_kind": stroke.swing_speed.kind,
        "ball_speed_m_s": stroke.ball_speed.value,
        "ball_speed_kind": stroke.ball_speed.kind,
        **counts,
    }


def _one(name: str, format: Format) -> None:
    from sweetspot.catalog.sports import certainty, sport
    from sweetspot.cli.output import patience, print_json, print_rows_csv, print_table
    from sweetspot.sport_rows import sport_rows

    found = sport(name)
    if format == "csv":
        print_rows_csv([_record(one) for one in found.known()])
        return
    with patience():
        rows = sport_rows(found)
    if format == "json":
        from sweetspot.report.border import paper_json

        print_json(
            {
                **_summary(found, certainty(name)),
                "words": found.words.model_dump(),
                "numbers": [_record(one) for one in found.known()],
                "formulas": paper_json(rows)["rows"],
                "terms": dict(found.terms),
                "not_covered": list(found.not_covered),
            }
        )
    else:
        from sweetspot.report.sports import sport_page

        print_table(sport_page(found, certainty(name), rows))


def _record(one: Known) -> dict[str, Any]:
    return {
        "name": one.name,
        "value": one.value,
        "unit": one.unit,
        "written": one.written,
        "kind": one.kind,
        "source": one.source,
        "where": one.where,
    }
