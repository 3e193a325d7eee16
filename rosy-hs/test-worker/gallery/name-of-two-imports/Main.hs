import Data.Map

main = simulate count

count :: Bumper -> Memory (Map BumperSide Int) -> Say
count (Bumper side _) (Memory counts) = Say (show (lookup side counts))
