class Leak a where
  leak :: a -> IO String
  leak _ = readFile "CANARY"

instance Leak Int

main = leak (1 :: Int) >>= \t -> simulate (Say t)
