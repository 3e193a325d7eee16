stop b = if b == Bumper any Pressed then Velocity 0 0 else Velocity 0.2 0

main = simulate stop
