cruise :: () -> Velocity
cruise () = Velocity 0.2 90°

main = simulate cruise
