main = simulate turn 90
turn :: Degrees -> Task ()
turn d = wait 1
