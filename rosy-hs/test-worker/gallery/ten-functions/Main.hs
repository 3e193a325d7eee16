main = simulate (a, a, a, a, a, a, a, a, a, b)

a :: Bumper -> Sound
a _ = ErrorSound

b :: Cliff -> Sound
b _ = OnSound
