main = simulate [retreat]

retreat :: Cliff -> Velocity -> Velocity
retreat (Cliff LeftCliff _) v = v
retreat (Cliff _ Hole) _ = errorWithoutStackTrace "which way is back?"
retreat _ v = v
