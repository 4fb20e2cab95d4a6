"""
Another sport: lead tape on a racket
====================================

The same collision in another sport: a racket of the catalog, with and without 6 g of lead at 3 and 9 o'clock.
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
# Beside the middle line the lead has more effect, because there the racket twists. Where does it help, and where does
# the slower swing cost more than the ball gains? The lower panel of the picture shows it for every place.
#
# ``sweetspot bats`` lists the whole catalog, and ``sweetspot show golf-driver`` prints an entry as a file to start
# from.
