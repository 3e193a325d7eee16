cruise :: () -> Velocity
cruise () = Velocity speed 0
  where
    var speed = 0.2

main = simulate cruise
