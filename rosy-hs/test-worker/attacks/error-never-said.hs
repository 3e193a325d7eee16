main = simulate broken

broken :: Velocity -> Maybe Sound
broken _ = error (let wait = wait in wait)
