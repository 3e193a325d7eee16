main = simulate f
f :: Bumper -> Velocity
f _ (Cliff _ Hole) = Velocity 0 0
f _ _ = Velocity 0.2 0
