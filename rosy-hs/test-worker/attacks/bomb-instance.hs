class Grow a where
  grow :: a -> Int

instance Grow [[a]] => Grow [a] where
  grow x = grow [x]

main = simulate (Say (show (grow "x")))
