type Speed :: Double

cruise :: () -> Velocity
cruise () = Velocity speed 0
  where speed = 0.3

main = simulate cruise
