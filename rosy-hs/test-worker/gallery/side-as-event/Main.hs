main = simulate f
f :: Cliff -> Sound
f (LeftCliff) = ErrorSound
f _ = ButtonSound
