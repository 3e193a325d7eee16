data Knock = Knock deriving (Eq)

cruise :: () -> Velocity
cruise () = Velocity 0.2 0

main = simulate (Knock, cruise)
