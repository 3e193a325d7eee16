{-# LANGUAGE UndecidableInstances #-}
class Loop a where loop :: a -> String
instance Loop [[a]] => Loop [a] where loop _ = loop ([] :: [[a]])

main = simulate (Say (loop "x"))
