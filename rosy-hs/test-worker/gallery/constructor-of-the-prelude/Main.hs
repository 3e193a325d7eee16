data Side = Left | Right

main = simulate (turn Left)

turn :: Side -> Velocity
turn Left = Velocity 0 1
turn Right = Velocity 0 (-1)
