{-# RULES "evil" forall x. x + 0 = error "HARM" #-}
main = simulate (Velocity 0 0)
