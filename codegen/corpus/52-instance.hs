data Temp = Cold | Warm | Hot deriving (Eq, Ord, Enum, Bounded)

instance Show Temp where
  show Cold = "brr"
  show Warm = "ok"
  show Hot = "ouch"

class Describe a where
  describe :: a -> String
  describe _ = "something"

instance Describe Temp where
  describe = show

main = simulate (Say (unwords (map describe [minBound .. maxBound :: Temp])))
