go = Velocity 0.5
main = simulate go
