1 cruise :: () -> Velocity
2 cruise () = Velocity 0.3 0
3
4 main = simulate cruise
