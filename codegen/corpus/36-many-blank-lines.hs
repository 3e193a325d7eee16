


go :: Velocity



go = Velocity 1 0




main :: IO ()

main = simulate go



