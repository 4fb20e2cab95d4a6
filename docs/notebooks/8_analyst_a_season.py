"""
Analyst: a season of batted balls
=================================

Give the program a table of balls in play. It returns every ball with its contact, its flight and its probability of
a home run. The season is made up, so that the truth is known: 8 players, 60 balls each.
"""

from pathlib import Path
from tempfile import mkdtemp

from sweetspot import catalog
from sweetspot.seasons.made_up import MadeSeason, made_season

folder = Path(mkdtemp())
table = made_season(catalog.bat("r161-ash"), MadeSeason(players=8, balls=60))
table.write_csv(folder / "made.csv")
table.select("batter", "launch_speed", "launch_angle", "hc_x", "hc_y", "bat_speed", "home_team").head(4)

# %%
# One call reads any number of such files, whatever the names of their columns:

from sweetspot.seasons.season_table import analyse_season

season = analyse_season([folder / "made.csv"], folder=folder / "answers")
balls = season.balls().collect()
balls.select(
    "launch_speed", "carry_ft", "squared_up_ratio", "from_tip_in", "from_tip_low90_in", "from_tip_high90_in"
).head(6)

# %%
# Is the place on the bat right? The made-up season knows. Nine intervals of ten should contain it:

import matplotlib.pyplot as plt

inside = balls["true_from_tip_in"].is_between(balls["from_tip_low90_in"], balls["from_tip_high90_in"])
print(f"{100 * inside.mean():.0f} % of the 90 % intervals contain the true place")
figure, axes = plt.subplots(figsize=(5, 4.4), layout="constrained")
axes.scatter(balls["true_from_tip_in"], balls["from_tip_in"], s=8)
axes.plot([0, 14], [0, 14], color="gray", lw=0.8)
axes.set(xlabel="true place, in from the tip", ylabel="estimated place, in from the tip", xlim=(0, 14), ylim=(0, 14))
plt.show()

# %%
# The bow is expected: exit speed falls on both sides of the best place, so a single ball cannot show on which side
# it was hit. Many balls, partly pooled, distinguish players:

from sweetspot.seasons.pooling import pooled

players, spread = pooled(season.counted(), key="batter", measure="exit_speed")
players.select("batter", "balls", "mean", "pooled", "low90", "high90")

# %%
# The command does the same for whole seasons and many machines: ``sweetspot season statcast_2024.csv.gz --out
# season``. See :doc:`the analyst's page </users/analyst>` and :doc:`the assumptions </theory/season>`.
