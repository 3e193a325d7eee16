data Robot = Robot
  { position :: Position
  , battery :: Double
  , name :: String
  } deriving (Show, Eq)

new :: Robot
new = Robot { position = Position 0 0, battery = 1, name = "Kobi" }

drain :: Robot -> Robot
drain r = r { battery = battery r - 0.1 }

rename :: String -> Robot -> Robot
rename n r@Robot { name = old, battery = _ } = r { name = old ++ n, battery = 1.0 }

main = simulate (Say (name (drain new)))
