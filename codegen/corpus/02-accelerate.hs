-- my first robot program :)
accelerate :: Velocity -> Velocity
accelerate (Velocity vl va) = Velocity (vl + 0.5) va

main :: IO ()
main = simulate accelerate
