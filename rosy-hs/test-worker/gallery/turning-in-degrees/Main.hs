cruise :: () -> Velocity
cruise () = Velocity 0 90

main = simulate cruise
