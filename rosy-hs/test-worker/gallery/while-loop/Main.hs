go = while True (Velocity 1 0)
main = simulate go
