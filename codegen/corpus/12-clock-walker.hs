walk :: Clock -> Velocity
walk (Clock _ _ s _)
    | even s    = Velocity 0.3 0
    | otherwise = Velocity 0 0.5

main :: IO ()
main = simulate walk
