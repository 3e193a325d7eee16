import System.IO.Unsafe

main = simulate (Velocity 0.5 0)
