cruise :: () => Velocity
cruise () = Velocity 0.3 0

main = simulate cruise
