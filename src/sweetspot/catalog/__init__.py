"""Known values: materials, balls and bats, each number with unit, spread, source and kind.

Data live in TOML files beside this module; physics never reads them.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
