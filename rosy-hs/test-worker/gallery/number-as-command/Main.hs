main = simulate speed

speed :: Bumper -> Double
speed _ = 0.5
