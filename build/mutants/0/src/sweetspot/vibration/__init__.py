"""How a bat vibrates: bending modes of its line, the effect of the hands; all end as one `Modes`."""
