"""Questions asked of the physics: where a bat hits best, what a change does, whether a rule is met."""
