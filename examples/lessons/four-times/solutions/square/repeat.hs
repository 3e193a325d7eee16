import Control.Monad

side :: Task ()
side = do
  drive 100
  turn 90

main = simulate (replicateM_ 4 side)
