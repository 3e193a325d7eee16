pair :: (a, b) -> (b, a)
pair (x, y) = (y, x)

showAll :: (Show a, Ord b) => a -> b -> b -> String
showAll a b c | b < c = show a
              | True = "no"

nested :: ((a -> b) -> c) -> (a -> b) -> [Maybe (Either a b)] -> c
nested f g _ = f g

long
  :: Bumper
  -> Memory (Maybe Int)
  -> (Velocity, Led1)
long _ _ = (Velocity 0 0, Led1 Red)

main = simulate long
