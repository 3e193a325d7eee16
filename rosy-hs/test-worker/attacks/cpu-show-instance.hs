data Endless = Endless

instance Show Endless where
  show _ = cycle "x"

main = simulate emit

emit :: Velocity -> Endless
emit _ = Endless
