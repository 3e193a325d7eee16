cruise :: () -> Velocity
cruise () = Velocity 1. 0

main = simulate cruise
