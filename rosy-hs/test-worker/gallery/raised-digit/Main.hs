area :: Double -> Double
area r = pi * r²

main = simulate (Velocity (area 0.2) 0)
