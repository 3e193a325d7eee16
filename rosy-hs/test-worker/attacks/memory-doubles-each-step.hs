main = simulate grow

grow :: Memory String -> Velocity -> (Memory String, Say)
grow (Memory t) _ = (Memory longer, Say (show (length longer)))
  where
    longer = 'x' : t ++ t
