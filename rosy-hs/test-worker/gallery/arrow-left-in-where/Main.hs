cruise :: () -> Velocity
cruise () = Velocity v 0
  where v <- 0.3

main = simulate cruise
