main = simulate broken

broken :: Velocity -> Maybe Sound
broken _ = error (let message = error message in message)
