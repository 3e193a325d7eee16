main = simulate $ do drive 50 turn 90
