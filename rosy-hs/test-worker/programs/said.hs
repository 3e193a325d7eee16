main = simulate (greet, light)

greet :: Button -> Maybe Say
greet (Button n Pressed) = Just (Say ("Hello, \"" ++ show n ++ "\" — günaydın!\n"))
greet _ = Nothing

light :: ButtonOne -> (Led1, Led2)
light (ButtonOne Pressed) = (Led1 Orange, Led2 Red)
light _ = (Led1 Black, Led2 Black)
