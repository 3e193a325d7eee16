main = simulate (\b = ErrorSound)
