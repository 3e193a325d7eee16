import Data.Lists

main = simulate (Velocity 0.5 0)
