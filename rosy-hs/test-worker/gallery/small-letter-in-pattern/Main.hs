lift :: Wheel -> Led1
lift (Wheel _ air) = Led1 Red
lift _ = Led1 Black

main = simulate lift
