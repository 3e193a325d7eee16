-- parametric events, two instances of one type, GADT-free; a polymorphic controller used at two types
newtype Tagged t a = Tagged a
data Fast
data Slow

tag :: Bumper -> (Tagged Fast Int, Tagged Slow Int)
tag _ = (Tagged 1, Tagged 2)

fast :: Tagged Fast Int -> Say
fast (Tagged n) = Say ("fast " ++ show n)

slow :: Tagged Slow Int -> Memory [Int] -> (Memory [Int], Say)
slow (Tagged n) (Memory ns) = (Memory (n : ns), Say ("slow " ++ show (length ns)))

main = simulate (tag, fast, slow, Velocity 0.3 0)
