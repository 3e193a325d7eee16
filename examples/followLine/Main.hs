-- Drives along a line on the floor.
followLine :: LineSensor -> Velocity
followLine LineAhead = Velocity 0.2 0
followLine LineLeft = Velocity 0.1 1
followLine LineRight = Velocity 0.1 (-1)
followLine NoLine = Velocity 0 0.5

main :: IO ()
main = simulate followLine
