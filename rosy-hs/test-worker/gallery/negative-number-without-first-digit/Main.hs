cruise :: () -> Velocity
cruise () = Velocity -.5 0

main = simulate cruise
