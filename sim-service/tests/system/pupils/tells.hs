-- A class of the program's own, with a default method and a parametric type.
class Tells a where
  tell :: a -> String
  tell _ = "?"

data Pair a b = Pair a b

instance (Tells a, Tells b) => Tells (Pair a b) where
  tell (Pair x y) = tell x ++ "&" ++ tell y

instance Tells Bool where
  tell b = if b then "yes" else "no"

instance Tells Int

pack :: Button -> Pair Bool Int
pack (Button _ s) = Pair (s == Pressed) 7

hear :: Pair Bool Int -> Say
hear p = Say (tell p)

main = simulate (pack, hear)
