main = simulate f
f :: Either Bumper Cliff -> Sound
f (Bumper _ _) = ErrorSound
f (Cliff _ _) = ButtonSound
