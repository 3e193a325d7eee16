main = simulate greet

greet :: Seconds -> Say
greet t = Say ("time: " ++ t)
