data Heap = Heap

instance Show Heap where
  show _ = cycle "{\"op\":\"said\"}\n"

main = simulate keep

keep :: Velocity -> Memory Heap
keep _ = Memory Heap
