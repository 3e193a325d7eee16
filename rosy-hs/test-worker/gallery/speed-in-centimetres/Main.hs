cruise :: () -> Velocity
cruise () = Velocity 20 0

main = simulate cruise
