"""Laboratory tests of bats, the rules that limit them, and measured shots."""
