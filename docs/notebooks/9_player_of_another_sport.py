"""
Another sport: lead tape on a racket
====================================

The same collision, another sport. A racket of the catalogue, and the same with 6 g of lead at 3 and 9 o'clock.
"""

from pathlib import Path
from tempfile import mkdtemp

import sweetspot

sweetspot.report("tennis-racket").plot()

# %%
# A file that begins with ``like`` needs only what is different:

mine = Path(mkdtemp()) / "mine.toml"
mine.write_text("""like = "tennis-racket"
name = "leaded"

[strings]
tension = "55 lb"

[[point_mass]]
position = "52 cm"
mass = "6 g"
beside = "12 cm"
""")
sweetspot.compare("tennis-racket", mine)

# %%
# Beside the middle line the lead does more, for there the racket twists. Where does it help, and where does the
# swing slow down more than the ball gains? The lower panel of the picture says it place for place.
#
# ``sweetspot bats`` lists everything there is, ``sweetspot show golf-driver`` prints any of it as a file to start
# from.
