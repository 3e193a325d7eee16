arc :: Velocity
arc = Velocity 0.2 0.4

main :: IO ()
main = simulate arc
