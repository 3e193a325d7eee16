main = simulate (f, g, h, play)

f :: Int -> Velocity
f _ = Velocity 0 0

g :: Int -> Velocity
g _ = Velocity 0.5 0

h :: Bumper -> Bool
h _ = True

play :: Bumper -> Sound
play _ = ErrorSound
