"""One file of HTML that a bat's maker can give away: it computes its hits itself, without a server or a network."""
