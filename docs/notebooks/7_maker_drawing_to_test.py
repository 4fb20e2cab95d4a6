"""
Maker: from a drawing to the test
=================================

Give the stations of a drawing. You get weight, balance, swing weight, tones and the test before any wood is turned.
"""

from pathlib import Path
from tempfile import mkdtemp

import sweetspot
from sweetspot import beam_model, catalog, rigid_body
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED

drawing = Path(mkdtemp()) / "drawing-12.toml"
drawing.write_text("""name = "drawing 12"
length = "34 in"
material = "maple"
profile = [
  ["0 in", "1.75 in"], ["0.3 in", "2.0 in"], ["0.6 in", "1.95 in"], ["1.25 in", "0.97 in"], ["9 in", "0.97 in"],
  ["15 in", "1.2 in"], ["20 in", "1.7 in"], ["25 in", "2.25 in"], ["30 in", "2.5 in"], ["32.8 in", "2.44 in"],
  ["33.85 in", "2.0 in"], ["34 in", "1.65 in"],
]
""")
bat = sweetspot.bat(drawing)
bat

# %%
# A cup removes weight where it matters most. How much, and what is the effect?

cupped = bat.cupped(diameter="1.4 in", depth="0.9 in")
for design in (bat, cupped):
    body = rigid_body(beam_model(design))
    print(f"{body.mass / OUNCE:5.1f} oz, MOI about 6 in {body.moi(6 * INCH) / OUNCE_INCH_SQUARED:,.0f} oz in2")

found = sweetspot.compare(bat, cupped, "torpedo")
found

# %%

found.plot()

# %%
# The torpedo is better inside and worse outside: it depends on where a batter meets the ball.
#
# Would an alloy bat of ours pass? Here is the simulated test, and the wall that would pass:

from sweetspot.analysis.certification.passing_wall import wall_that_passes

sweetspot.certify("single-wall")

# %%

wall = wall_that_passes(catalog.bat("single-wall"), ball=catalog.ball(), limit=0.5)
print(f"{1e3 * wall.thickness:.2f} mm, {wall.factor:.2f} times the drawing's")
print(f"the bat would weigh {wall.mass / OUNCE:.1f} oz")

# %%
# For the lathe, ``sweetspot outline drawing-12.toml --out bat.dxf --out bat.svg`` writes the drawing, and :doc:`the
# maker's page </users/maker>` explains how to read one back.
