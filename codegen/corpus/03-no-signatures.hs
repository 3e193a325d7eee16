go = Velocity 0.3 0
stop = Velocity 0 0
main = simulate go
