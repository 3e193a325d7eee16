-- Ten seconds ahead, then five seconds round, whatever is in the way.
wander :: Clock -> Velocity
wander (Clock _ _ second _)
  | second `mod` 15 < 10 = Velocity 0.2 0
  | otherwise = Velocity 0 0.5

main :: IO ()
main = simulate wander
