main = simulate fail'

fail' :: Velocity -> Maybe Sound
fail' _ = error (cycle "no end ")
