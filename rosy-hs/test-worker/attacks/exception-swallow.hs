import Control.Exception

main = simulate (Velocity 0 0) `catch` (\e -> const (simulate (Velocity 1 0)) (e :: SomeException))
