"""Pictures of a bat and its hits, drawn with matplotlib's figures only: no global state is read or changed."""
