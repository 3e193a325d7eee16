data Heap = Heap

instance Show Heap where
  show _ = error (cycle "x")

main = simulate keep

keep :: Velocity -> Memory Heap
keep _ = Memory Heap
