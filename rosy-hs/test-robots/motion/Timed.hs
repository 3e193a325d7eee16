-- Stops three seconds after the start of the program.
forAWhile :: Seconds -> Velocity
forAWhile now
  | now < 3 = Velocity 0.15 0
  | otherwise = Velocity 0 0

main :: IO ()
main = simulate forAWhile
