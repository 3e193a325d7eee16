cruise :: () -> Velocity
cruise () = Velocity (0,5) 0

main = simulate cruise
